//! Morgan McGuire and Louis Bavoil, *Weighted Blended Order-Independent Transparency*, Journal of Computer Graphics
//! Techniques 2(2), 2013.
//!
//! One pass over the surfaces, in any order, makes two results for each pixel. One is the sum of the colours, weighted by
//! distance. The other is the product of what the surfaces let through. So the surfaces cover what lies behind them exactly
//! as much as they should, and their own colours are mixed.

use super::paper::Paper;
use crate::papers::stage;
use crate::steps;
use crate::steps::{
    Dialect, Format, Framebuffer, Holds, Listing, Map, Resources, Shader, Target, Text, gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "mcguire",
    citation: "Morgan McGuire and Louis Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013",
    texts: &[("weighted-blended", Text::Listing(WEIGHTED_BLENDED, &[]))],
    resources: &[&stage::RESOURCES, &RESOURCES],
    claims: &[],
    errata: &[],
};

/// The whole algorithm.
pub const WEIGHTED_BLENDED: Listing = Listing {
    title: "Weighted blended transparency: a sum and a product, then the mean colour over the opaque image",
    source: "McGuire and Bavoil 2013",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the paper's equations, in calls of OpenGL 4";
        run stage::OPAQUE_FIRST;
        run ADD_UP;
        run COMPOSITE;
    },
};

const ADD_UP: Listing = Listing {
    title: "Weighted colours are added, transmittances multiplied",
    source: "McGuire and Bavoil 2013, the transparent pass",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(SUMS);
        glClearBufferfv(0, NOTHING);
        glClearBufferfv(1, EVERYTHING);
        glDepthMask(false);
        glEnable(BLEND);
        glBlendFunci(0, ONE, ONE);
        glBlendFunci(1, ZERO, ONE_MINUS_SRC_ALPHA);
        glUseProgram(ACCUMULATE);
        drawTransparentObjects();
    },
};

/// Its blend function for colours; alpha stays the opaque image's.
const COMPOSITE: Listing = Listing {
    title: "The weighted mean covers the opaque image as much as the surfaces do",
    source: "McGuire and Bavoil 2013, equation 6",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(stage::COMPOSITE);
        glDisable(DEPTH_TEST);
        glBlendFuncSeparate(ONE_MINUS_SRC_ALPHA, SRC_ALPHA, ZERO, ONE);
        glUseProgram(MEAN);
        glActiveTexture(2);
        glBindTexture(ACCUMULATED);
        glActiveTexture(3);
        glBindTexture(REVEALAGE);
        drawScreen();
        glDisable(BLEND);
        glDepthMask(true);
    },
};

const NOTHING: [f32; 4] = [0.0; 4];
const EVERYTHING: [f32; 4] = [1.0; 4];

/// The maps and framebuffers that the algorithm takes for granted. The sum of many weights does not fit into 8 bits, even if
/// the image has 8.
pub const RESOURCES: Resources = Resources {
    maps: &[
        (ACCUMULATED, Holds::Exactly(Format::Rgba32F)),
        (REVEALAGE, Holds::Exactly(Format::R32F)),
    ],
    framebuffers: &[Framebuffer::new(
        SUMS,
        &[ACCUMULATED, REVEALAGE],
        Some(stage::OPAQUE_DEPTH),
    )],
    ..Resources::NONE
};

/// The sum of the weighted colours, which are premultiplied. Alpha has the sum of the weighted opacities.
pub const ACCUMULATED: Map = Map::named("weighted colors");
/// The product of the transmittances of all fragments.
pub const REVEALAGE: Map = Map::named("revealage");

const SUMS: Target = Target("weighted sums");
const ACCUMULATE: Shader = Shader("weighted/accumulate");
const MEAN: Shader = Shader("weighted/composite");
