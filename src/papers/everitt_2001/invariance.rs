//! "An Invariance Issue": amendments to Listing 1 that make depth unit 0 in other ways.
//!
//! The listing that runs sets the variables `quotient`, `in_shader`, `steps` and `bias`, which the shaders of
//! `glsl/invariance/` describe.

use crate::papers::stage;
use crate::steps;
use crate::steps::{Amendment, Kind, Map, Resources, Shader, Step};

/// The stored depth is the rasteriser's.
pub const WINDOW_Z: &[Amendment] = &[
    program(steps! { glUseProgram(STORES_WINDOW_Z); run UNIFORMS; }),
    PASS_0,
    TEXELS,
];

/// The stored depth is r/q.
pub const REPLACED: &[Amendment] = &[
    program(steps! { glUseProgram(STORES_QUOTIENT); run UNIFORMS; }),
    PASS_0,
    TEXELS,
];

/// What they take for granted: the variables that say what is compared, where, and by which margin.
pub const TRIED: Resources = Resources {
    variables: &["quotient", "in_shader", "steps", "bias", "depth_test"],
    ..Resources::NONE
};

const fn program(amended: &'static [Step]) -> Amendment {
    Amendment {
        key: "E06",
        kind: Kind::Edition,
        place: "Listing 1, render scene",
        printed: steps! { glUseProgram(stage::PEEL_SURFACE); },
        amended,
        why: "what is stored and what is compared can be chosen",
        test: "e06_comparing_r_over_q_with_the_rasterisers_depth_mis_peels",
    }
}

const UNIFORMS: crate::steps::Listing = crate::steps::Listing {
    title: "What is compared, where, and by which margin",
    source: "Everitt 2001, An Invariance Issue",
    dialect: crate::steps::Dialect::Calls,
    steps: steps! {
        edition "what is stored and what is compared can be chosen";
        glUniform1f("quotient");
        glUniform1f("in_shader");
        glUniform1f("steps");
        glUniform1f("bias");
        glUniform1f("depth_test");
    },
};

/// A shader that compares has to be told that the first pass has no comparison.
const PASS_0: Amendment = Amendment {
    key: "E06",
    kind: Kind::Edition,
    place: "Listing 1, depth unit 0",
    printed: steps! {
        if (i == 0) {
            disable depth test;
        } else {
            enable depth test;
        }
    },
    amended: steps! {
        if (i == 0) {
            disable depth test;
            depth_test = 0;
        } else {
            enable depth test;
            depth_test = 1;
        }
        glUniform1f("depth_test");
    },
    why: "the shader compares only where depth unit 0 is enabled",
    test: "e06_window_z_compared_in_the_shader_and_in_the_sampler_give_the_same_image",
};

/// The same texture where it can be read without comparison.
const TEXELS: Amendment = Amendment {
    key: "E06",
    kind: Kind::Edition,
    place: "Listing 1, depth unit 0, bind buffer A",
    printed: steps! { bind buffer A; },
    amended: steps! {
        bind buffer A;
        glActiveTexture(4);
        glBindTexture(DEPTH_BUFFER_A);
    },
    why: "a comparison in the shader reads texels",
    test: "e06_window_z_compared_in_the_shader_and_in_the_sampler_give_the_same_image",
};

const DEPTH_BUFFER_A: Map = Map::at("depth buffer", "A");
const STORES_WINDOW_Z: Shader = Shader("invariance/window_z");
const STORES_QUOTIENT: Shader = Shader("invariance/replaced");
