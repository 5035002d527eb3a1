//! A record of what happens to each fragment of a pixel, draw by draw, and its table.

use std::fmt;

use super::color::Texel;
use super::lists::{RayRun, Resolved};
use crate::steps::{Map, Objects, Target};

/// The stage at which a fragment ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FragmentOutcome {
    /// The shader discarded it.
    Discarded,
    /// It failed the stencil test.
    StencilFail,
    /// It passed the stencil test and failed the depth test.
    DepthFail,
    /// It passed every test.
    Pass,
}

/// A fragment's way through the stages.
#[derive(Clone, Debug, PartialEq)]
pub struct Fate {
    /// The fragment's place in the order of submission.
    pub order: u32,
    /// The fragment's depth.
    pub depth: f32,
    /// The stage at which it ended.
    pub outcome: FragmentOutcome,
    /// The pixel's stencil value before and after it.
    pub stencil: [u8; 2],
    /// The pixel's stored depth before and after it (the raw integer, if the format has fixed point).
    pub stored_depth: [f32; 2],
    /// The pixel's texel before and after it, in each color map of the framebuffer, in the order of [`Draw::colors`].
    pub colors: Vec<[Texel; 2]>,
    /// The images into which its shader stored something, and their texels before and after it.
    pub images: Vec<(Option<Map>, [Texel; 2])>,
    /// What became of it in the pixel's fragment list, if its shader makes one.
    pub list: Option<InList>,
}

/// What becomes of a fragment in its pixel's fragment list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum InList {
    /// It became the record of this number, from 0 in the order of filling.
    Stored(u32),
    /// The list had no room for it.
    NoRoom,
}

/// One draw of a pixel's fragments.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// The program that drew.
    pub program: &'static str,
    /// The objects that were drawn.
    pub objects: Objects,
    /// The framebuffer, if one was bound.
    pub target: Option<Target>,
    /// The framebuffer's color maps by the shaders' locations, each by the name that it had, if another has not taken it.
    pub colors: Vec<Option<Map>>,
    /// The framebuffer's depth map, likewise.
    pub depth: Option<Map>,
    /// The fragments, in the order in which they were drawn.
    pub fates: Vec<Fate>,
    /// The pixel's stencil value and stored depth at the end.
    pub left: (u8, f32),
}

/// A draw that resolved the pixel's fragment list.
#[derive(Clone, Debug, PartialEq)]
pub struct Resolve {
    /// The program that drew.
    pub program: &'static str,
    /// The number of elements of its Local Array, which is also the complexity segment's (ppAO).
    pub size: u32,
    /// The result, subpass by subpass.
    pub resolved: Resolved,
    /// The ray that was cast between the fragments, event by event, if the scene has volumes.
    pub ray: Option<RayRun>,
}

/// Every draw of surfaces at one pixel, and every draw that resolved its list, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    /// The draws of surfaces.
    pub draws: Vec<Draw>,
    /// The draws that resolved the list.
    pub resolves: Vec<Resolve>,
}

impl Draw {
    /// The places in the order of submission of the fragments that ended so.
    pub fn with(&self, outcome: FragmentOutcome) -> Vec<u32> {
        let ended_so = |fate: &&Fate| fate.outcome == outcome;
        self.fates
            .iter()
            .filter(ended_so)
            .map(|fate| fate.order)
            .collect()
    }
}

impl fmt::Display for FragmentOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Discarded => "clipped",
            Self::StencilFail => "stencil fail",
            Self::DepthFail => "depth fail",
            Self::Pass => "pass",
        })
    }
}

impl fmt::Display for Draw {
    /// Prints one line per fragment. Values that a fragment did not change are not repeated.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "  surface   depth        fate          stencil      depth buffer"
        )?;
        for fate in &self.fates {
            let [before, after] = fate.stencil;
            let stencil = match before == after {
                true => format!("{before}"),
                false => format!("{before} -> {after}"),
            };
            let [before, after] = fate.stored_depth;
            let depth = match before == after {
                true => format!("{before}"),
                false => format!("{before} -> {after}"),
            };
            let name = format!("s{}", fate.order);
            writeln!(
                f,
                "  {name:<9} {:<12} {:<13} {stencil:<12} {depth}",
                fate.depth, fate.outcome
            )?;
        }
        let (stencil, depth) = self.left;
        writeln!(f, "  at the end: stencil {stencil}, depth {depth}")
    }
}
