//! Cass Everitt, *Interactive Order-Independent Transparency*, NVIDIA, 15 May 2001.
//!
//! Listing 1 is the algorithm, written for an OpenGL with two depth units; [`DepthUnits`](crate::steps::DepthUnits)
//! runs it on a real one, as "Shadow Mapping as Depth Test" proposes. The paper describes compositing in a sentence
//! ("Putting It All Together"), which is [`COMPOSITE`] here.

mod claims;
pub(super) mod composite;
mod errata;
mod invariance;
pub(super) mod listing_1;
mod listing_2;
mod shadow;

pub use composite::{ALPHA, COMPOSITE, COMPOSITING};
pub use invariance::{REPLACED, TRIED, WINDOW_Z};
pub use listing_1::LISTING_1;
pub use listing_2::{ENABLED, LISTING_2};
pub use shadow::{
    COMBINED, COMBINED_AS_IT_IS, INTO_ALPHA, LOOKED_UP_AS_2D, MODULATED, RECTANGLE_FILLINGS,
    SGIX_GEQUAL, SGIX_LEQUAL, SHADOW_AS_DEPTH_TEST, SHADOW_FILLINGS, TEXELS,
};

use super::paper::Paper;
use super::{stage, vtk};
use crate::steps::{Listing, Resources, Text};

/// The paper's texts. Listing 1 needs no amendment; with VTK's it is part of [`vtk::KEEP_LAYERS`].
pub const PAPER: Paper = Paper {
    key: "everitt",
    citation: "Cass Everitt, Interactive Order-Independent Transparency, NVIDIA 2001",
    texts: &[
        ("listing-1", Text::Listing(LISTING_1, &[])),
        ("listing-2", Text::Listing(LISTING_2, &[ENABLED])),
        (
            "shadow-as-depth-test",
            Text::Listing(SHADOW_AS_DEPTH_TEST, &SHADOW_FILLINGS),
        ),
        (
            "sgix-shadow",
            Text::Listing(
                Listing {
                    title: "The same by SGIX_shadow and register combiners, as a GeForce3 had them in 2001",
                    ..SHADOW_AS_DEPTH_TEST
                },
                &[COMBINED, LOOKED_UP_AS_2D],
            ),
        ),
        ("composite", Text::Listing(COMPOSITE, &[ALPHA])),
    ],
    resources: &[
        &Resources::NONE.of(&["listing-2", "shadow-as-depth-test", "sgix-shadow"], &[]),
        &Resources {
            maps: vtk::PEELING.maps,
            made: &[composite::LAYER_I],
            variables: &["num_passes"],
            ..Resources::NONE.of(&["listing-1"], &[])
        },
        &COMPOSITING.of(&["composite"], &[stage::LAYER]),
    ],
    claims: claims::CLAIMS,
    errata: errata::ERRATA,
};
