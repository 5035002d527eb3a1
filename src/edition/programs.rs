//! The programs: what a machine needs to run a method from its texts, on one pixel, from nothing to the image.
//!
//! A program is a text as it stands wherever a paper's or this edition's text is whole. Where a method decides something
//! between two of its texts, the decision is a step like any other ([`Program::rest`]).

use crate::methods::options::LISTING_1_AND_STATE;
use crate::papers::carr_2008::{coherent, hybrid, ideal};
use crate::papers::lindholm_2015::components;
use crate::papers::{bavoil_2008, edition, everitt_2001, stage, vtk};
use crate::steps;
use crate::steps::{Dialect, Listing, Map, Query, Reading, Resources, Text};

/// A method's texts, and what they take for granted.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// Its name: the paper's key, and what of the paper it runs.
    pub key: &'static str,
    /// The method's name in the registry.
    pub method: &'static str,
    /// The text.
    pub text: Text,
    /// What the text takes for granted besides the common stage's. Colours are 32-bit floats, and so are depths, beside 8 bits
    /// of stencil.
    pub besides: &'static [&'static Resources],
    /// The variables that have values before it begins. Infinity is no limit.
    pub variables: &'static [(&'static str, f64)],
    /// Whether the method draws the triangles of sorted meshes front to back, after the others.
    pub sorts: bool,
    /// The number of elements of the Local Array, if there is one.
    pub array: Option<u32>,
    /// What is done when the text is at its end, if a method does something then.
    pub rest: Option<Rest>,
}

/// What the verified painter does with a pixel that failed.
#[derive(Clone, Copy, Debug)]
pub struct Rest {
    /// The samples of this query say whether there is anything to do.
    pub unless_zero: Query,
    /// Resolves the list of the pixel's fragments before the opaque depth, in the order of submission.
    pub lists: Text,
    /// What lies behind these fragments.
    pub behind: Map,
    /// Where the result goes.
    pub into: Map,
    /// Then this runs.
    pub then: Text,
}

impl Program {
    const NONE: Self = Self {
        key: "",
        method: "",
        text: Text::Listing(EVERITT, &[]),
        besides: &[],
        variables: &[],
        sorts: false,
        array: None,
        rest: None,
    };

    /// What a listing takes for granted. Pseudocode takes nothing.
    pub fn resources(&self) -> Vec<&'static Resources> {
        let common = match self.text {
            Text::Listing(..) => Some(&stage::RESOURCES),
            Text::Pseudocode(..) | Text::Lists(..) => None,
        };
        common
            .into_iter()
            .chain(self.besides.iter().copied())
            .collect()
    }

    /// The readings in which the program differs, each with the others that are the same.
    pub fn readings(&self) -> Vec<Vec<Reading>> {
        let mut different: Vec<Vec<Reading>> = Vec::new();
        for reading in Reading::ALL {
            let print = |reading| self.text.print(reading);
            let same = different
                .iter_mut()
                .find(|it| print(it[0]) == print(reading));
            match same {
                Some(same) => same.push(reading),
                None => different.push(vec![reading]),
            }
        }
        different
    }
}

/// Every program.
pub const fn all() -> &'static [Program] {
    PROGRAMS
}

const LIMIT: &[(&str, f64)] = &[("iteration_limit", f64::INFINITY)];
const PEELS: &[(&str, f64)] = &[
    ("num_passes", f64::INFINITY),
    ("occlusion_ratio", 0.0),
    ("window_area", 1.0),
];

const PROGRAMS: &[Program] = &[
    Program {
        key: "everitt/depth-peeling",
        method: "depth-peeling",
        text: Text::Listing(EVERITT, &[everitt_2001::ALPHA]),
        besides: &[&vtk::PEELING],
        variables: &[("num_passes", 4.0)],
        ..Program::NONE
    },
    Program {
        key: "vtk/keep-layers",
        method: "depth-peeling",
        text: Text::Listing(vtk::KEEP_LAYERS, &[]),
        besides: &[&vtk::PEELING],
        variables: PEELS,
        ..Program::NONE
    },
    Program {
        key: "vtk/on-the-fly",
        method: "depth-peeling",
        text: Text::Listing(vtk::ON_THE_FLY, &[]),
        besides: &[&vtk::PEELING, &stage::ACCUMULATING],
        variables: PEELS,
        ..Program::NONE
    },
    Program {
        key: "carr/layer-peeling",
        method: "layer-peeling",
        text: Text::Listing(hybrid::LAYER_PEELING, &hybrid::AMENDMENTS),
        besides: &hybrid::RESOURCES,
        variables: LIMIT,
        ..Program::NONE
    },
    Program {
        key: "carr/hybrid",
        method: "hybrid-layer-peeling",
        text: Text::Listing(hybrid::HYBRID, &hybrid::AMENDMENTS),
        besides: &hybrid::RESOURCES,
        variables: LIMIT,
        ..Program::NONE
    },
    Program {
        key: "carr/coherent-a",
        method: "coherent-layer-peeling-a",
        text: Text::Listing(coherent::VARIANT_A, &coherent::AMENDMENTS),
        besides: &coherent::RESOURCES_A,
        variables: LIMIT,
        ..Program::NONE
    },
    Program {
        key: "carr/coherent-b",
        method: "coherent-layer-peeling-b",
        text: Text::Listing(coherent::VARIANT_B, &coherent::AMENDMENTS),
        besides: &coherent::RESOURCES_B,
        variables: LIMIT,
        ..Program::NONE
    },
    Program {
        key: "carr/ideal",
        method: "ideal-coherent-layer-peeling",
        text: Text::Listing(ideal::IDEAL, &ideal::AMENDMENTS),
        besides: &[&ideal::RESOURCES],
        variables: LIMIT,
        ..Program::NONE
    },
    Program {
        key: "carr/algorithm-1",
        method: "hybrid-layer-peeling",
        text: Text::Pseudocode(hybrid::ALGORITHM_1, &hybrid::AMENDMENTS_1),
        sorts: true,
        ..Program::NONE
    },
    Program {
        key: "carr/algorithm-2",
        method: "ideal-coherent-layer-peeling",
        text: Text::Pseudocode(ideal::ALGORITHM_2, &ideal::AMENDMENTS_2),
        ..Program::NONE
    },
    Program {
        key: "bavoil/dual-peeling",
        method: "dual-depth-peeling",
        text: Text::Listing(bavoil_2008::DUAL_DEPTH_PEELING, &[]),
        besides: &[&bavoil_2008::RESOURCES],
        variables: PEELS,
        ..Program::NONE
    },
    Program {
        key: "lindholm/static-array",
        method: "ffb",
        text: Text::Lists(components::STATIC_ARRAY, &[]),
        array: Some(4),
        ..Program::NONE
    },
    Program {
        key: "lindholm/pp-ao",
        method: "ffb+ppao",
        text: Text::Lists(components::PP_AO, &[components::PP_AO_AMENDMENT]),
        array: Some(8),
        ..Program::NONE
    },
    Program {
        key: "lindholm/pp-dp",
        method: "ffb+ppdp",
        text: Text::Lists(components::PP_DP, &components::PP_DP_AMENDMENTS),
        array: Some(4),
        ..Program::NONE
    },
    Program {
        key: "lindholm/pp-ao+pp-dp",
        method: "ffb+ppao+ppdp",
        text: Text::Lists(components::PP_AO, &[components::PP_AO_WITH_PP_DP]),
        array: Some(8),
        ..Program::NONE
    },
    Program {
        key: "edition/verified-painter",
        method: "verified-painter",
        text: Text::Listing(edition::VERIFIED_PAINTER, &[]),
        besides: &[&edition::RESOURCES],
        array: Some(8),
        rest: Some(Rest {
            unless_zero: edition::FAILED,
            lists: Text::Lists(components::PP_AO, &[components::PP_AO_WITH_PP_DP]),
            behind: edition::BEHIND,
            into: edition::RESOLVED,
            then: Text::Listing(edition::PLACE_RESOLVED, &[]),
        }),
        ..Program::NONE
    },
];

/// Everitt's method from beginning to end, all objects peeled. The paper has Listing 1, and a sentence on what comes after.
const EVERITT: Listing = Listing {
    title: "Depth peeling, then the layers back to front",
    source: "Everitt 2001",
    dialect: Dialect::Calls,
    steps: steps! {
        run LISTING_1_AND_STATE;
        edition "the layers go over the background, and there are as many as passes";
        glBindFramebuffer(stage::COMPOSITE);
        num_layers = num_passes;
        run everitt_2001::COMPOSITE;
    },
};
