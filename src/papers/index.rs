//! Which listings there are, by paper.

use super::{everitt_2001, vtk};
use crate::steps::{Amendment, Listing};

/// A paper and its listings.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The name on the command line.
    pub key: &'static str,
    /// Authors, year and title.
    pub citation: &'static str,
    /// Its listings: name on the command line, listing, and what stands beside it.
    pub listings: &'static [(&'static str, Listing, &'static [Amendment])],
}

/// Every paper whose listings are here.
pub const fn papers() -> &'static [Paper] {
    &[
        Paper {
            key: "everitt",
            citation: "Cass Everitt, Interactive Order-Independent Transparency, NVIDIA 2001",
            listings: &[
                (
                    "listing-1",
                    everitt_2001::LISTING_1,
                    &[vtk::CULL_BY_OPAQUE, vtk::QUERY, vtk::KEEP_DEPTH],
                ),
                ("composite", everitt_2001::COMPOSITE, &[everitt_2001::ALPHA]),
            ],
        },
        Paper {
            key: "vtk",
            citation: "VTK wiki, Depth Peeling, 2006",
            listings: &[
                ("opaque-first", vtk::OPAQUE_FIRST, &[]),
                ("keep-layers", vtk::KEEP_LAYERS, &[]),
                ("on-the-fly", vtk::ON_THE_FLY, &[]),
            ],
        },
    ]
}
