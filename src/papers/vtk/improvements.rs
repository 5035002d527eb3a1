//! This edition's improvements of [`ON_THE_FLY`](super::ON_THE_FLY). The image of each is the same to the last bit.

use super::{CULL_BY_OPAQUE, DEPTH_BUFFER_B, PIXELS, QUERY, UNDER_LAYER};
use crate::papers::stage::{ACCUMULATION, OPAQUE_DEPTH, OVER_OPAQUE};
use crate::steps;
use crate::steps::{Amendment, Kind, Map, Shader, gl::*};

/// The count of a layer's pixels is read after the next peel has been submitted, so that nothing waits for the layer. Two
/// queries a peel become one. The price is a peel behind the empty one: N layers take N + 2 peels.
pub const LATE_QUERY: [Amendment; 3] = [
    Amendment {
        key: "late query",
        kind: Kind::Edition,
        place: "Listing 1, render scene",
        printed: QUERY.amended,
        amended: steps! {
            drawTransparentObjects();
            peels = i + 1;
            if (i > 0) {
                pixels = samples(PIXELS);
                stop if (pixels == 0) because EmptyLayer;
                stop if (pixels < (occlusion_ratio * window_area)) because OcclusionRatio;
                composited = composited + pixels;
                num_layers = i;
            }
        },
        why: "the layer before this peel has been counted by now",
        test: "a_query_that_is_read_a_peel_late_costs_one_peel_and_changes_no_bit",
    },
    Amendment {
        key: "late query",
        kind: Kind::Edition,
        place: "Listing 1, save color buffer RGBA as layer i",
        printed: steps! {
            pixels = samples(PIXELS);
            composited = composited + pixels;
            num_layers = i + 1;
            stop if (pixels < (occlusion_ratio * window_area)) because OcclusionRatio;
        },
        amended: steps! {},
        why: "it is read a peel late",
        test: "a_query_that_is_read_a_peel_late_costs_one_peel_and_changes_no_bit",
    },
    Amendment {
        key: "late query",
        kind: Kind::Edition,
        place: "after the last peel",
        printed: steps! { run OVER_OPAQUE; },
        amended: steps! {
            run OVER_OPAQUE;
            pixels = samples(PIXELS);
            composited = composited + pixels;
            if (pixels > 0) {
                num_layers = num_layers + 1;
            }
        },
        why: "no peel comes after the last layer",
        test: "a_query_that_is_read_a_peel_late_costs_one_peel_and_changes_no_bit",
    },
];

/// Pixels die: where a peel finds nothing, the later ones find nothing, either. While a layer goes under the others, the
/// next peel's depth buffer is made: the opaque depth where there is a layer, and 0 elsewhere. No fragment lies before
/// 0, so the depth test rejects all that is left of a dead pixel before it is shaded, as a stencil test would. No peel but
/// the first copies the opaque depth.
///
/// The opaque depth must come out of a texture as it went in, so this asks for depths that are floats.
pub const ALIVE: [Amendment; 3] = [
    Amendment {
        key: "alive",
        kind: Kind::Edition,
        place: "Listing 1, depth unit 1, clear depth buffer",
        printed: CULL_BY_OPAQUE.amended,
        amended: steps! {
            if (i == 0) {
                glCopyImageSubData(OPAQUE_DEPTH, DEPTH_BUFFER_B);
            }
        },
        why: "the layer before has made this peel's depth buffer",
        test: "only_pixels_that_are_alive_are_peeled_and_no_bit_changes",
    },
    Amendment {
        key: "alive",
        kind: Kind::Edition,
        place: "Listing 1, save color buffer RGBA as layer i",
        printed: steps! {
            glBindFramebuffer(ACCUMULATION);
            glEnable(BLEND);
        },
        amended: steps! {
            glBindFramebuffer(ACCUMULATION);
            glFramebufferDepth(DEPTH_BUFFER_A);
            glClearDepth(0.0);
            glClear(DEPTH_BUFFER_BIT);
            glDepthFunc(ALWAYS);
            glEnable(BLEND);
        },
        why: "the depths before this peel's are no longer needed: the next peel's go there",
        test: "only_pixels_that_are_alive_are_peeled_and_no_bit_changes",
    },
    Amendment {
        key: "alive",
        kind: Kind::Edition,
        place: "Listing 1, save color buffer RGBA as layer i",
        printed: steps! { glUseProgram(UNDER_LAYER); },
        amended: steps! {
            if (i == 0) {
                glUseProgram(UNDER_FIRST);
            } else {
                glUseProgram(UNDER_LATER);
            }
        },
        why: "a pixel of the layer is alive in the next peel",
        test: "only_pixels_that_are_alive_are_peeled_and_no_bit_changes",
    },
];

const DEPTH_BUFFER_A: Map = Map::at("depth buffer", "A");
/// Puts the nearest layer into the accumulation, and says which pixels are alive.
pub const UNDER_FIRST: Shader = Shader("alive/first");
/// The same for a layer behind others.
pub const UNDER_LATER: Shader = Shader("alive/later");
