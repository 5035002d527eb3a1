//! Nathan Carr, Radomír Měch and Gavin Miller, *Coherent Layer Peeling for Transparent High-Depth-Complexity Scenes*,
//! Graphics Hardware 2008.
//!
//! | in the paper | here |
//! | --- | --- |
//! | section 5, passes 1 to 4, as printed | [`passes`] |
//! | section 5, the loop around them, passes 5 and 6, for which it has prose | [`coherent`], variant A |
//! | section 6, as printed, and the loop with it | [`passes::SECTION_6`], [`coherent`], variant B |
//! | Algorithm 1, hybrid layer peeling | [`hybrid`] |
//! | Algorithm 2, the ideal GPU | [`ideal`] |
//! | layer peeling, as the paper counts it | [`hybrid::LAYER_PEELING`] |
//!
//! Amendments beside each listing correct errors of the printed text, and fill what it leaves open.
//!
//! The paper's letters: `s_c` is the last surface that was peeled, `s_n` the first behind it, `D(s)` a surface's depth.

mod claims;
pub mod coherent;
mod errata;
pub mod hybrid;
pub mod ideal;
pub mod passes;
mod shared;

pub use shared::*;

use super::paper::Paper;
use super::stage;
use crate::steps::{Resources, Shader, Text};

/// The texts that begin with the opaque objects and end with the image.
const WHOLE: &[&str] = &[
    "coherent-a",
    "coherent-b",
    "layer-peeling",
    "hybrid",
    "ideal",
];

const PASS_6_SHADERS: &[Shader] = &[AT_BOUND_AS_PRINTED, AT_BOUND];
const COHERENT_SHADERS: &[Shader] = &[CLOSED_CLOSED, CLOSED_OPEN, coherent::NEXT_BOUND];

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "carr",
    citation: "Nathan Carr, Radomír Měch, Gavin Miller, Coherent Layer Peeling for Transparent \
               High-Depth-Complexity Scenes, Graphics Hardware 2008",
    texts: &[
        ("pass-1", Text::Listing(passes::PASS_1, &[])),
        ("pass-2", Text::Listing(passes::PASS_2, &[])),
        ("pass-3", Text::Listing(passes::PASS_3, &[])),
        ("pass-4", Text::Listing(passes::PASS_4, &[])),
        (
            "pass-5",
            Text::Listing(coherent::PASS_5, &[coherent::NO_TESTS]),
        ),
        (
            "pass-6",
            Text::Listing(coherent::PASS_6, &[coherent::BEFORE_OPAQUE]),
        ),
        (
            "section-6",
            Text::Listing(passes::SECTION_6, &[coherent::MOVE_DEPTH]),
        ),
        (
            "coherent-a",
            Text::Listing(coherent::VARIANT_A, &coherent::AMENDMENTS),
        ),
        (
            "coherent-b",
            Text::Listing(coherent::VARIANT_B, &coherent::AMENDMENTS),
        ),
        (
            "layer-peeling",
            Text::Listing(hybrid::LAYER_PEELING, &hybrid::AMENDMENTS),
        ),
        ("hybrid", Text::Listing(hybrid::HYBRID, &hybrid::AMENDMENTS)),
        ("ideal", Text::Listing(ideal::IDEAL, &ideal::AMENDMENTS)),
        (
            "algorithm-1",
            Text::Pseudocode(hybrid::ALGORITHM_1, &hybrid::AMENDMENTS_1),
        ),
        (
            "algorithm-2",
            Text::Pseudocode(ideal::ALGORITHM_2, &ideal::AMENDMENTS_2),
        ),
    ],
    resources: &[
        &Resources::NONE.of(
            &[
                "pass-1",
                "pass-2",
                "pass-3",
                "pass-4",
                "pass-5",
                "section-6",
            ],
            &[],
        ),
        &Resources::NONE.of(&["pass-6"], PASS_6_SHADERS),
        &stage::RESOURCES.of(WHOLE, &[stage::SURFACE, stage::LAYER]),
        &coherent::RESOURCES_A[0].of(&["coherent-a", "coherent-b"], COHERENT_SHADERS),
        &coherent::RESOURCES_A[0].of(&["coherent-a", "coherent-b"], PASS_6_SHADERS),
        &coherent::RESOURCES_A[1].of(&["coherent-a"], &[OPEN_OPEN, OPEN_CLOSED]),
        &coherent::RESOURCES_B[1].of(
            &["coherent-b"],
            &[coherent::PREVIOUS_DEPTH, coherent::PREVIOUS_DEPTH_FROM_NEAR],
        ),
        &hybrid::RESOURCES[0].of(&["layer-peeling", "hybrid"], PASS_6_SHADERS),
        &hybrid::RESOURCES[1].of(&["layer-peeling", "hybrid"], &[OPEN_OPEN, CLOSED_OPEN]),
        &Resources::NONE.of(&["hybrid"], &[hybrid::BETWEEN_PEELS_AS_PRINTED]),
        &ideal::RESOURCES.of(&["ideal"], ideal::SHADERS),
    ],
    claims: claims::CLAIMS,
    errata: errata::ERRATA,
};
