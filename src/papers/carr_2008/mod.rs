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
use crate::steps::Text;

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
        &stage::RESOURCES,
        hybrid::RESOURCES[0],
        hybrid::RESOURCES[1],
        &ideal::RESOURCES,
        coherent::RESOURCES_B[0],
        coherent::RESOURCES_B[1],
    ],
    claims: claims::CLAIMS,
    errata: errata::ERRATA,
};
