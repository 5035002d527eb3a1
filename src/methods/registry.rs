//! The registry: which methods there are. It feeds the command line, the help, the documentation and the tests.

use std::fmt;
use std::str::FromStr;

use super::depth_peeling::DepthPeelingOptions;
use crate::error::{Error, Result};

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
    /// Every fragment captured, sorted and composited in f64.
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
    /// Whether its image is exact when nothing stops it early.
    pub exact: bool,
    /// What becomes of fragments of equal depth.
    pub ties: &'static str,
    /// What its memory grows with.
    pub memory: &'static str,
    /// Extensions that it needs beyond OpenGL 4.3.
    pub needs: &'static [&'static str],
}

/// Every method, in the order in which `compare` shows them.
pub const fn registry() -> &'static [Entry] {
    const DEPTH_PEELING: DepthPeelingOptions = DepthPeelingOptions {
        maximum_number_of_peels: 0,
        occlusion_ratio: 0.0,
        compositing: super::depth_peeling::Compositing::OnTheFly,
        as_printed: false,
        amendments: &[],
    };
    &[
        Entry {
            name: "blend",
            method: Method::Blend,
            source: "Everitt 2001, figure 1b",
            exact: false,
            ties: "order of submission",
            memory: "pixels",
            needs: &[],
        },
        Entry {
            name: "painter",
            method: Method::Painter,
            source: "Carr et al. 2008, section 1",
            exact: false,
            ties: "order of submission",
            memory: "pixels + triangles",
            needs: &[],
        },
        Entry {
            name: "depth-peeling",
            method: Method::DepthPeeling(DEPTH_PEELING),
            source: "Everitt 2001; VTK",
            exact: true,
            ties: "the first submitted, the others lost and counted",
            memory: "pixels (layers x pixels if they are kept)",
            needs: &[],
        },
        Entry {
            name: "exact",
            method: Method::Exact,
            source: "the oracle",
            exact: true,
            ties: "order of submission",
            memory: "fragments, in pieces",
            needs: &[],
        },
    ]
}

impl Method {
    /// Its entry in the registry.
    pub fn entry(&self) -> &'static Entry {
        let same =
            |entry: &&Entry| std::mem::discriminant(&entry.method) == std::mem::discriminant(self);
        registry()
            .iter()
            .find(same)
            .expect("every method is in the registry")
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.entry().name)
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
                    format!("the methods are {}", names.join(", ")),
                )
            })
    }
}
