//! The registry: which methods there are. It feeds the command line, the help, the documentation and the tests.

use std::fmt;
use std::str::FromStr;

use super::a_buffer::{ABufferOptions, Manager};
use super::coherent_layer_peeling::{CoherentOptions, Variant};
use super::coplanar_depth_peeling::CoplanarDepthPeelingOptions;
use super::depth_peeling::DepthPeelingOptions;
use super::dual_depth_peeling::DualDepthPeelingOptions;
use super::ideal_coherent_layer_peeling::{self as ideal, IdealOptions};
use super::layer_peeling::LayerPeelingOptions;
use super::sorting::Sorting;
use crate::error::{Error, Result, did_you_mean};
use crate::gl::Driver;

/// A method with its options.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// Blending in the order of submission.
    Blend,
    /// Triangles sorted by centroid, then blended.
    Painter,
    /// Depth peeling, Everitt 2001 and VTK.
    DepthPeeling(DepthPeelingOptions),
    /// Dual depth peeling, Bavoil and Myers 2008.
    DualDepthPeeling(DualDepthPeelingOptions),
    /// Depth peeling that takes every fragment of each depth, after Vasilakis and Fudos 2013.
    CoplanarDepthPeeling(CoplanarDepthPeelingOptions),
    /// Layer peeling in two geometry passes an iteration, Carr et al. 2008.
    LayerPeeling(LayerPeelingOptions),
    /// Hybrid layer peeling, Carr et al. 2008, Algorithm 1.
    HybridLayerPeeling(LayerPeelingOptions),
    /// Coherent layer peeling, Carr et al. 2008, sections 5 and 6.
    CoherentLayerPeeling(CoherentOptions),
    /// Coherent layer peeling on an ideal GPU, Carr et al. 2008, Algorithm 2.
    IdealCoherentLayerPeeling(IdealOptions),
    /// A-buffers, Lindholm et al. 2015.
    ABuffer(ABufferOptions),
    /// Every fragment captured, sorted and composited in f64, with the volumes between them.
    Exact,
}

/// What there is to know about a method before it runs.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name on the command line.
    pub name: &'static str,
    /// With its default options.
    pub method: Method,
    /// Where it is published.
    pub source: &'static str,
    /// Whether its image is exact when nothing stops it early, but for the rounding of the colours it keeps: of surfaces.
    pub exact: bool,
    /// Whether it is exact of volumes, too: a ray takes the samples that the oracle's takes, while slices have an error of
    /// order 1 in their distance. None if it renders no volumes.
    pub exact_volumes: Option<bool>,
    /// Both in words, with what limits them.
    pub exactness: &'static str,
    /// What it keeps of a pixel that has more fragments than its array has room for ([`Keep`](super::Keep)); none if it
    /// has no array that could be too small.
    pub keeps: Option<&'static str>,
    /// What becomes of fragments of equal depth.
    pub ties: &'static str,
    /// What its memory grows with.
    pub memory: &'static str,
    /// Extensions beyond OpenGL 4.3 of which it needs one; none if it needs none.
    pub needs: &'static [&'static str],
}

impl Entry {
    /// Whether a driver offers what it needs.
    pub fn runs_on(&self, driver: &Driver) -> bool {
        self.needs.is_empty() || self.needs.iter().any(|extension| driver.has(extension))
    }
}

/// Every method, in the order in which `compare` shows them.
pub const fn registry() -> &'static [Entry] {
    ENTRIES
}

const DEPTH_PEELING: DepthPeelingOptions = DepthPeelingOptions {
    maximum_number_of_peels: 0,
    occlusion_ratio: 0.0,
    compositing: super::depth_peeling::Compositing::OnTheFly,
    as_printed: false,
    depth_unit_0: super::depth_unit_0::DepthUnit0::Sampler,
    amendments: &[],
};

const EXACT_BUT_NOT_SLICES: &str =
    "yes; volumes as slices: no, an error of order 1 in the slices' distance";
const EXACT_BUT_FOR_TIES: &str =
    "yes, but for ties; volumes as slices: no, an error of order 1 in the slices' distance";
const EXACT_BY_RAYS: &str = "yes, volumes by rays, too";

const ENTRIES: &[Entry] = &[
    Entry {
        name: "blend",
        method: Method::Blend,
        source: "Everitt 2001, figure 1b",
        exact: false,
        exact_volumes: None,
        exactness: "no",
        keeps: None,
        ties: "order of submission",
        memory: "pixels",
        needs: &[],
    },
    Entry {
        name: "painter",
        method: Method::Painter,
        source: "Carr et al. 2008, section 1",
        exact: false,
        exact_volumes: Some(false),
        exactness: "no",
        keeps: None,
        ties: "order of submission",
        memory: "pixels + triangles",
        needs: &[],
    },
    Entry {
        name: "depth-peeling",
        method: Method::DepthPeeling(DEPTH_PEELING),
        source: "Everitt 2001; VTK",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_FOR_TIES,
        keeps: None,
        ties: "the first submitted, the others lost and counted",
        memory: "pixels (layers x pixels if they are kept)",
        needs: &[],
    },
    Entry {
        name: "dual-depth-peeling",
        method: Method::DualDepthPeeling(DualDepthPeelingOptions {
            maximum_number_of_peels: 0,
            occlusion_ratio: 0.0,
            amendments: &[],
        }),
        source: "Bavoil and Myers 2008; VTK today",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission",
        memory: "pixels",
        needs: &[],
    },
    Entry {
        name: "coplanar-depth-peeling",
        method: Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions {
            maximum_number_of_peels: 0,
        }),
        source: "Vasilakis and Fudos 2013",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission",
        memory: "pixels",
        needs: &[],
    },
    Entry {
        name: "layer-peeling",
        method: Method::LayerPeeling(LayerPeelingOptions { as_printed: false }),
        source: "Carr et al. 2008, sections 1 and 8",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission",
        memory: "pixels",
        needs: &[],
    },
    Entry {
        name: "hybrid-layer-peeling",
        method: Method::HybridLayerPeeling(LayerPeelingOptions { as_printed: false }),
        source: "Carr et al. 2008, Algorithm 1",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "unsorted meshes before sorted ones",
        memory: "pixels, triangles",
        needs: &[],
    },
    Entry {
        name: "coherent-layer-peeling-a",
        method: Method::CoherentLayerPeeling(COHERENT_A),
        source: "Carr et al. 2008, section 5",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission after sorting",
        memory: "pixels, triangles",
        needs: &[],
    },
    Entry {
        name: "coherent-layer-peeling-b",
        method: Method::CoherentLayerPeeling(COHERENT_B),
        source: "Carr et al. 2008, section 6",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission after sorting",
        memory: "pixels, triangles",
        needs: &[],
    },
    Entry {
        name: "ideal-coherent-layer-peeling",
        method: Method::IdealCoherentLayerPeeling(IdealOptions {
            sorting: SORTING,
            tight_bound: false,
            as_printed: false,
            access: ideal::BufferAccess::Best,
        }),
        source: "Carr et al. 2008, Algorithm 2",
        exact: true,
        exact_volumes: Some(false),
        exactness: EXACT_BUT_NOT_SLICES,
        keeps: None,
        ties: "order of submission after sorting",
        memory: "pixels, triangles",
        needs: ideal::NEEDS,
    },
    a_buffer("ffb", Manager::Ffb, false, false),
    a_buffer("ffb+ppao", Manager::Ffb, true, false),
    a_buffer("ffb+ppdp", Manager::Ffb, false, true),
    a_buffer("ffb+ppao+ppdp", Manager::Ffb, true, true),
    a_buffer("dfb", Manager::Dfb, false, false),
    a_buffer("dfb+ppao", Manager::Dfb, true, false),
    a_buffer("dfb+ppdp", Manager::Dfb, false, true),
    a_buffer("dfb+ppao+ppdp", Manager::Dfb, true, true),
    a_buffer("ppll", Manager::Ppll, false, false),
    a_buffer("ppll+ppao", Manager::Ppll, true, false),
    a_buffer("ppll+ppdp", Manager::Ppll, false, true),
    a_buffer("ppll+ppao+ppdp", Manager::Ppll, true, true),
    Entry {
        name: "exact",
        method: Method::Exact,
        source: "the oracle",
        exact: true,
        exact_volumes: Some(true),
        exactness: EXACT_BY_RAYS,
        keeps: None,
        ties: "order of submission",
        memory: "fragments, in pieces",
        needs: &[],
    },
];

/// An A-buffer's entry. `static` is the paper's word for the array without ppAO and ppDP.
const fn a_buffer(name: &'static str, manager: Manager, pp_ao: bool, pp_dp: bool) -> Entry {
    Entry {
        name,
        method: Method::ABuffer(ABufferOptions {
            manager,
            pp_ao,
            pp_dp,
            ..ABufferOptions::DEFAULT
        }),
        source: "Lindholm et al. 2015",
        exact: true,
        exact_volumes: Some(true),
        exactness: match pp_dp {
            true => EXACT_BY_RAYS,
            false => "yes, volumes by rays, too, up to 64 fragments a pixel (--array)",
        },
        keeps: match (pp_dp, manager) {
            (true, _) => None,
            (false, Manager::Ffb | Manager::Dfb) => Some("the first submitted"),
            (false, Manager::Ppll) => Some("the last submitted"),
        },
        ties: "order of submission",
        memory: match manager {
            Manager::Ffb => "pixels x layers, in bands",
            Manager::Dfb | Manager::Ppll => "pixels + fragments, in bands",
        },
        needs: &[],
    }
}

const SORTING: Sorting = Sorting::Buckets(256);

const COHERENT_A: CoherentOptions = coherent(Variant::A);
const COHERENT_B: CoherentOptions = coherent(Variant::B);

const fn coherent(variant: Variant) -> CoherentOptions {
    CoherentOptions {
        variant,
        sorting: SORTING,
        tie_friendly: false,
        stop_early: false,
        batches: 0,
        as_printed: false,
        amendments: &[],
    }
}

impl Method {
    /// Its name in the registry.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Blend => "blend",
            Self::Painter => "painter",
            Self::DepthPeeling(_) => "depth-peeling",
            Self::DualDepthPeeling(_) => "dual-depth-peeling",
            Self::CoplanarDepthPeeling(_) => "coplanar-depth-peeling",
            Self::LayerPeeling(_) => "layer-peeling",
            Self::HybridLayerPeeling(_) => "hybrid-layer-peeling",
            Self::CoherentLayerPeeling(options) => match options.variant {
                Variant::A => "coherent-layer-peeling-a",
                Variant::B => "coherent-layer-peeling-b",
            },
            Self::IdealCoherentLayerPeeling(_) => "ideal-coherent-layer-peeling",
            Self::ABuffer(options) => options.name(),
            Self::Exact => "exact",
        }
    }

    /// Whether it renders volumes, too, without being asked to draw them as slices; the others refuse a scene with
    /// volumes.
    pub const fn renders_volumes(&self) -> bool {
        self.casts_rays() || matches!(self, Self::HybridLayerPeeling(_))
    }

    /// Whether it casts rays through volumes.
    pub const fn casts_rays(&self) -> bool {
        matches!(self, Self::Exact | Self::ABuffer(_))
    }

    /// Whether it can draw volumes as slices ([`Renderer::with_slices`](super::Renderer::with_slices)): whatever draws
    /// surfaces in an order that is more than that of submission.
    pub const fn takes_slices(&self) -> bool {
        !self.casts_rays() && !matches!(self, Self::Blend)
    }

    /// Its entry in the registry.
    pub fn entry(&self) -> &'static Entry {
        registry()
            .iter()
            .find(|entry| entry.name == self.name())
            .expect("every method is in the registry")
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Method {
    type Err = Error;

    /// A method by its name, with its default options.
    fn from_str(name: &str) -> Result<Self> {
        registry()
            .iter()
            .find(|entry| entry.name == name)
            .map(|entry| entry.method)
            .ok_or_else(|| {
                let names: Vec<_> = registry().iter().map(|entry| entry.name).collect();
                Error::usage(
                    format!("there is no method '{name}'"),
                    did_you_mean(name, &names),
                )
            })
    }
}
