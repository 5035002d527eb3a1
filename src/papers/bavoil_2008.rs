//! Louis Bavoil and Kevin Myers, *Order Independent Transparency with Dual Depth Peeling*, NVIDIA, February 2008.
//!
//! One pass peels a layer from the front and one from the back. VTK uses this algorithm today.
//!
//! The paper blends all three targets by MAX, because the hardware of its year had one blend equation for all draw
//! buffers. But the maximum of two colours is a third colour that nobody has drawn. OpenGL 4.0 blends each draw buffer
//! in its own way, so here MAX is for the depths alone. Colours of equal depth go under one another in the order of
//! submission, and none is lost.

use super::paper::Paper;
use crate::papers::stage;
use crate::steps;
use crate::steps::{
    Dialect, Format, Framebuffer, Holds, Listing, Map, Query, Resources, Shader, Target, Text,
    gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "bavoil",
    citation: "Louis Bavoil and Kevin Myers, Order Independent Transparency with Dual Depth Peeling, NVIDIA 2008",
    texts: &[("dual-peeling", Text::Listing(DUAL_DEPTH_PEELING, &[]))],
    resources: &[&stage::RESOURCES, &RESOURCES],
    claims: &[],
    errata: &[],
};

/// The whole algorithm. Before it runs, `num_passes`, `occlusion_ratio` and `window_area` are set.
pub const DUAL_DEPTH_PEELING: Listing = Listing {
    title: "Dual depth peeling: the nearest and the farthest layer in one pass",
    source: "Bavoil and Myers 2008",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the paper's algorithm, in calls of OpenGL 4";
        run stage::OPAQUE_FIRST;
        run NOTHING_PEELED;
        run FIRST_DEPTHS;
        peels = 0;
        for (i in 0..num_passes) {
            stop if (pixels == 0) because EmptyLayer;
            changed = pixels;
            A = i % 2;
            B = (i + 1) % 2;
            run PEEL;
            run BACK_OVER_BACK;
            peels = i + 1;
            glActiveTexture(2);
            glBindTexture(DEPTHS_B);
            run COUNT_PIXELS_LEFT;
            stop if (pixels == 0) because EmptyLayer;
            stop if (changed < (occlusion_ratio * window_area)) because OcclusionRatio;
        }
        run FRONT_OVER_BACK_OVER_OPAQUE;
    },
};

const NOTHING_PEELED: Listing = Listing {
    title: "Nothing at the front, nothing at the back",
    source: "Bavoil and Myers 2008",
    dialect: Dialect::Calls,
    steps: steps! {
        glDepthMask(false);
        glBindFramebuffer(PEELS);
        glClearBufferfv(1, CLEAR);
        glBindFramebuffer(BACK);
        glClearBufferfv(0, CLEAR);
    },
};

/// The pass before the first peel. The opaque depth culls here and in every peel.
const FIRST_DEPTHS: Listing = Listing {
    title: "Where the nearest and the farthest fragments are",
    source: "Bavoil and Myers 2008, initialisation of the min-max depth buffer",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(DEPTHS_ALONE);
        glClearBufferfv(0, NOTHING);
        glEnable(BLEND);
        glBlendEquationi(0, MAX);
        glUseProgram(FIND_DEPTHS);
        drawTransparentObjects();
        glActiveTexture(2);
        glBindTexture(DEPTHS_0);
        run COUNT_PIXELS_LEFT;
    },
};

const PEEL: Listing = Listing {
    title: "The nearest to the front, the farthest to the back, the next depths between them",
    source: "Bavoil and Myers 2008, geometry pass",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(PEELS);
        glFramebufferColor(DEPTHS_B);
        glClearBufferfv(0, NOTHING);
        glClearBufferfv(2, CLEAR);
        glEnable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendEquationi(0, MAX);
        glBlendFunci(1, ONE_MINUS_DST_ALPHA, ONE);
        glBlendFunci(2, ONE_MINUS_DST_ALPHA, ONE);
        glActiveTexture(2);
        glBindTexture(DEPTHS_A);
        glUseProgram(DUAL_PEEL);
        drawTransparentObjects();
    },
};

const BACK_OVER_BACK: Listing = Listing {
    title: "What was farthest, over what was farther",
    source: "Bavoil and Myers 2008, blending the back colour",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BACK);
        glDisable(DEPTH_TEST);
        glBlendEquationi(0, FUNC_ADD);
        glBlendFunci(0, ONE, ONE_MINUS_SRC_ALPHA);
        glUseProgram(stage::LAYER);
        glActiveTexture(2);
        glBindTexture(FARTHEST);
        drawScreen();
    },
};

/// The depths in texture unit 2 say where fragments are left. So the loop ends without an empty pass over the geometry,
/// after N/2 + 1 passes for N layers.
const COUNT_PIXELS_LEFT: Listing = Listing {
    title: "In how many pixels something is left",
    source: "Bavoil and Myers 2008, occlusion query",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BACK);
        glDisable(DEPTH_TEST);
        glDisable(BLEND);
        glColorMask(false, false, false, false);
        glUseProgram(LEFT);
        glBeginQuery(PIXELS);
        drawScreen();
        glEndQuery(PIXELS);
        glColorMask(true, true, true, true);
        pixels = samples(PIXELS);
    },
};

const FRONT_OVER_BACK_OVER_OPAQUE: Listing = Listing {
    title: "The front over the back over the opaque image",
    source: "Bavoil and Myers 2008, final pass",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(stage::COMPOSITE);
        glDisable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendEquationi(0, FUNC_ADD);
        glBlendFunci(0, ONE, ONE_MINUS_SRC_ALPHA);
        glUseProgram(stage::LAYER);
        glActiveTexture(2);
        glBindTexture(BACK_COLOR);
        drawScreen();
        glBindTexture(FRONT_COLOR);
        drawScreen();
        glDisable(BLEND);
        glDepthMask(true);
    },
};

/// Counts the fragments that are left between the depths in texture unit 2. This is not part of the algorithm.
pub const COUNT_FRAGMENTS_LEFT: Listing = Listing {
    title: "How many fragments are left",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glActiveTexture(2);
        glBindTexture(DEPTHS_B);
        glBindFramebuffer(stage::DEPTH_ALONE);
        glEnable(DEPTH_TEST);
        glDepthMask(false);
        glUseProgram(REST);
        glBeginQuery(FRAGMENTS_LEFT);
        drawTransparentObjects();
        glEndQuery(FRAGMENTS_LEFT);
        glDepthMask(true);
    },
};

const CLEAR: [f32; 4] = [0.0; 4];
/// The value of `NOTHING` in glsl/common/dual.glsl.
const NOTHING: [f32; 4] = [-2.0; 4];

/// Its maps and framebuffers. The opaque depth culls in all but the back's.
pub const RESOURCES: Resources = Resources {
    maps: &[
        (DEPTHS[0], Holds::Exactly(Format::Rg32F)),
        (DEPTHS[1], Holds::Exactly(Format::Rg32F)),
        (FRONT_COLOR, Holds::Colors),
        (BACK_COLOR, Holds::Colors),
        (FARTHEST, Holds::Colors),
    ],
    framebuffers: &[
        Framebuffer::new(DEPTHS_ALONE, &[DEPTHS[0]], Some(stage::OPAQUE_DEPTH)),
        Framebuffer::new(
            PEELS,
            &[DEPTHS[0], FRONT_COLOR, FARTHEST],
            Some(stage::OPAQUE_DEPTH),
        ),
        Framebuffer::new(BACK, &[BACK_COLOR], None),
    ],
    variables: &["num_passes", "occlusion_ratio", "window_area"],
    ..Resources::NONE
};

/// The negated nearest and the farthest depth of the fragments that are left, before and after a peel.
pub const DEPTHS: [Map; 2] = [DEPTHS_0, Map::numbered("depths", 1)];
/// The light of the layers peeled from the front, premultiplied.
pub const FRONT_COLOR: Map = Map::named("front");
/// The light of the layers peeled from the back, premultiplied.
pub const BACK_COLOR: Map = Map::named("back");
/// The farthest layer that this peel has found, premultiplied.
pub const FARTHEST: Map = Map::named("farthest");
/// The depths alone, culled by the opaque depth.
pub const DEPTHS_ALONE: Target = Target("depths alone");
/// The next depths, the front, and the farthest layer, culled by the opaque depth.
pub const PEELS: Target = Target("dual peel");
/// The back alone.
pub const BACK: Target = Target("back");
/// Counts what [`COUNT_FRAGMENTS_LEFT`] has drawn.
pub const FRAGMENTS_LEFT: Query = Query("fragments left");

const DEPTHS_0: Map = Map::numbered("depths", 0);
const DEPTHS_A: Map = Map::at("depths", "A");
const DEPTHS_B: Map = Map::at("depths", "B");
const FIND_DEPTHS: Shader = Shader("dual/depths");
const DUAL_PEEL: Shader = Shader("dual/peel");
const LEFT: Shader = Shader("dual/left");
const REST: Shader = Shader("dual/rest");
const PIXELS: Query = Query("pixels");
