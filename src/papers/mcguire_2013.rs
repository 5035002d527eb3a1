//! Morgan McGuire and Louis Bavoil, *Weighted Blended Order-Independent Transparency*, Journal of Computer Graphics
//! Techniques 2(2), 2013.
//!
//! Two sums in one pass, in whatever order: of colours, weighted by distance, and of what comes through. So what lies
//! behind is covered exactly as much as it should be, and the colours of the covering surfaces are mixed.

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
    title: "Weighted blended transparency: two sums, then their quotient over the opaque image",
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
    title: "The weighted mean, over the opaque image as far as that is covered",
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

/// What it takes for granted. Sums of many weights do not fit into 8 bits, whatever the image has.
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

/// The sum of weighted colours, premultiplied, and in alpha that of the weighted opacities.
pub const ACCUMULATED: Map = Map::named("weighted colors");
/// The product of what each fragment lets through.
pub const REVEALAGE: Map = Map::named("revealage");

const SUMS: Target = Target("weighted sums");
const ACCUMULATE: Shader = Shader("weighted/accumulate");
const MEAN: Shader = Shader("weighted/composite");
