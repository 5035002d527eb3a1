//! Which listings there are, by paper.

use super::carr_2008::{coherent, hybrid, ideal, passes};
use super::lindholm_2015::{components, fused};
use super::{bavoil_2008, everitt_2001, lindholm_2015, stage, vasilakis_2013, vtk};
use crate::steps::pseudo::{Algorithm, Line, list};
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
    /// Its algorithms in pseudocode, likewise.
    pub algorithms: &'static [(&'static str, Algorithm, &'static [Amendment<Line>])],
    /// Its algorithms on lists of fragments, likewise.
    pub list_algorithms: &'static [ListAlgorithm],
}

/// The name on the command line, the algorithm, and what stands beside it.
type ListAlgorithm = (
    &'static str,
    Algorithm<list::Line>,
    &'static [Amendment<list::Line>],
);

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
                ("listing-2", everitt_2001::LISTING_2, &[]),
                (
                    "shadow-as-depth-test",
                    everitt_2001::SHADOW_AS_DEPTH_TEST,
                    &[],
                ),
                ("composite", everitt_2001::COMPOSITE, &[everitt_2001::ALPHA]),
            ],
            algorithms: &[],
            list_algorithms: &[],
        },
        Paper {
            key: "vtk",
            citation: "VTK wiki, Depth Peeling, 2006",
            listings: &[
                ("opaque-first", stage::OPAQUE_FIRST, &[]),
                ("keep-layers", vtk::KEEP_LAYERS, &[]),
                ("on-the-fly", vtk::ON_THE_FLY, &[]),
            ],
            algorithms: &[],
            list_algorithms: &[],
        },
        Paper {
            key: "carr",
            citation: "Nathan Carr, Radomír Měch, Gavin Miller, Coherent Layer Peeling for Transparent \
                       High-Depth-Complexity Scenes, Graphics Hardware 2008",
            listings: &[
                ("pass-1", passes::PASS_1, &[]),
                ("pass-2", passes::PASS_2, &[]),
                ("pass-3", passes::PASS_3, &[]),
                ("pass-4", passes::PASS_4, &[]),
                ("pass-5", coherent::PASS_5, &[coherent::NO_TESTS]),
                ("pass-6", coherent::PASS_6, &[coherent::BEFORE_OPAQUE]),
                ("section-6", passes::SECTION_6, &[coherent::MOVE_DEPTH]),
                ("coherent-a", coherent::VARIANT_A, &coherent::AMENDMENTS),
                ("coherent-b", coherent::VARIANT_B, &coherent::AMENDMENTS),
                ("layer-peeling", hybrid::LAYER_PEELING, &hybrid::AMENDMENTS),
                ("hybrid", hybrid::HYBRID, &hybrid::AMENDMENTS),
                ("ideal", ideal::IDEAL, &ideal::AMENDMENTS),
            ],
            algorithms: &[
                ("algorithm-1", hybrid::ALGORITHM_1, &hybrid::AMENDMENTS_1),
                ("algorithm-2", ideal::ALGORITHM_2, &ideal::AMENDMENTS_2),
            ],
            list_algorithms: &[],
        },
        Paper {
            key: "lindholm",
            citation: "Stefan Lindholm, Martin Falk, Erik Sundén, Anders Ynnerman, Timo Ropinski, Hybrid Data Visualization \
                       Based on Depth Complexity Histogram Analysis, Computer Graphics Forum 2015",
            listings: &[
                ("complexity-image", lindholm_2015::COMPLEXITY_IMAGE, &[]),
                (
                    "clear-and-fill",
                    lindholm_2015::CLEAR_AND_FILL,
                    &[lindholm_2015::BEGIN_AT_OFFSETS, lindholm_2015::ORDERED],
                ),
                ("resolve", lindholm_2015::RESOLVE, &[]),
                (
                    "pp-ao",
                    lindholm_2015::PP_AO,
                    &[lindholm_2015::BY_COUNTER, lindholm_2015::NO_STENCIL],
                ),
            ],
            algorithms: &[],
            list_algorithms: &[
                (
                    "section-4",
                    components::STATIC_ARRAY,
                    &[components::KEEP_NEAREST],
                ),
                (
                    "section-5.1",
                    components::PP_AO,
                    &[components::PP_AO_AMENDMENT],
                ),
                (
                    "section-5.2",
                    components::PP_DP,
                    &components::PP_DP_AMENDMENTS,
                ),
                ("section-6.1", fused::FUSED, &fused::FUSED_AMENDMENTS),
                (
                    "section-6.1-pp-dp",
                    fused::PP_DP_ON_RAYS,
                    &fused::FUSED_PP_DP,
                ),
            ],
        },
        Paper {
            key: "bavoil",
            citation: "Louis Bavoil and Kevin Myers, Order Independent Transparency with Dual Depth Peeling, NVIDIA 2008",
            listings: &[("dual-peeling", bavoil_2008::DUAL_DEPTH_PEELING, &[])],
            algorithms: &[],
            list_algorithms: &[],
        },
        Paper {
            key: "vasilakis",
            citation: "Andreas Vasilakis and Ioannis Fudos, Depth-Fighting Aware Methods for Multifragment Rendering, TVCG 2013",
            listings: &[("coplanar-peeling", vasilakis_2013::COPLANAR_PEELING, &[])],
            algorithms: &[],
            list_algorithms: &[],
        },
    ]
}
