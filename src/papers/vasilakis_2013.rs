//! Andreas Vasilakis and Ioannis Fudos, *Depth-Fighting Aware Methods for Multifragment Rendering*, IEEE Transactions
//! on Visualization and Computer Graphics 19(6), 2013: depth peeling that loses no coplanar fragment.
//!
//! A layer takes two geometry passes. The first is Everitt's and finds the layer's depth. The second counts and takes
//! every fragment at exactly that depth. Here it is Listing 1 once more, with two amendments: the second pass again
//! uses two depth units, with unit 1 set to EQUAL. (The authors keep the fragments apart and sort them by primitive;
//! blending takes them in the order of submission by itself, which is onionskin's policy for equal depths.)

use super::paper::Paper;
use crate::papers::everitt_2001::listing_1::LISTING_1;
use crate::papers::{stage, vtk};
use crate::steps;
use crate::steps::{
    Amendment, Dialect, Framebuffer, Holds, Kind, Listing, Query, Resources, Shader, Text, gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "vasilakis",
    citation: "Andreas Vasilakis and Ioannis Fudos, Depth-Fighting Aware Methods for Multifragment Rendering, TVCG 2013",
    texts: &[("coplanar-peeling", Text::Listing(COPLANAR_PEELING, &[]))],
    resources: &[&stage::RESOURCES, &RESOURCES],
    claims: &[],
    errata: &[],
};

/// Listing 1 with every fragment of each depth. Before it runs, `num_passes` is set.
pub const COPLANAR_PEELING: Listing = Listing {
    title: "Depth peeling that takes every fragment of each depth",
    source: "Vasilakis and Fudos 2013",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the paper's idea, on Listing 1";
        run stage::OPAQUE_FIRST;
        run stage::CLEAR_ACCUMULATION;
        run vtk::BEFORE_PEELING;
        num_layers = 0;
        composited = 0;
        run LISTING_1 amended by &[vtk::NO_CLEAR, vtk::CULL_BY_OPAQUE, vtk::QUERY, EVERY_FRAGMENT];
        run stage::OVER_OPAQUE;
    },
};

/// Instead of saving the layer, this draws the scene once more and puts all fragments at the layer's depth under those
/// before them. The query counts these fragments, so that the number of missing fragments is known at the end.
pub const EVERY_FRAGMENT: Amendment = Amendment {
    key: "VX03",
    kind: Kind::Edition,
    place: "Listing 1, save color buffer RGBA as layer i",
    printed: steps! { save color buffer RGBA as layer i; },
    amended: steps! {
        glBindFramebuffer(stage::ACCUMULATION);
        depth unit 0: {
            enable depth test;
            bindDepthBuffer(stage::OPAQUE_DEPTH);
            set depth func to LESS;
        }
        depth unit 1: {
            bind buffer B;
            disable depth writes;
            set depth func to EQUAL;
        }
        glEnable(BLEND);
        glBlendFunc(ONE_MINUS_DST_ALPHA, ONE);
        glUseProgram(COPLANAR);
        glBeginQuery(AT_THIS_DEPTH);
        drawTransparentObjects();
        glEndQuery(AT_THIS_DEPTH);
        glDisable(BLEND);
        composited = composited + samples(AT_THIS_DEPTH);
        num_layers = i + 1;
        glBindFramebuffer(stage::PEEL);
        glUseProgram(stage::PEEL_SURFACE);
    },
    why: "a layer is every fragment at its depth, not one of them",
    test: "vx03_coplanar_peeling_has_every_tie_in_the_order_of_submission",
};

/// The first pass of each layer draws depths alone; the second is tested against them.
pub const RESOURCES: Resources = Resources {
    maps: &[
        (stage::ACCUMULATED, Holds::Colors),
        (vtk::DEPTH_BUFFERS[0], Holds::Depths),
        (vtk::DEPTH_BUFFERS[1], Holds::Depths),
    ],
    framebuffers: &[
        Framebuffer::new(stage::PEEL, &[], Some(vtk::DEPTH_BUFFERS[0])),
        Framebuffer::new(
            stage::ACCUMULATION,
            &[stage::ACCUMULATED],
            Some(vtk::DEPTH_BUFFERS[0]),
        ),
    ],
    variables: &["num_passes"],
    ..Resources::NONE
};

const COPLANAR: Shader = Shader("coplanar");
const AT_THIS_DEPTH: Query = Query("at this depth");
