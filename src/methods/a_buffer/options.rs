//! Options of A-buffers.
//!
//! What the paper lists in full, or what has only two answers, can be matched without a wildcard. The rest is
//! `non_exhaustive`, because there are more ways to sort and to fill than these.

pub use crate::gl::network::LARGEST_NETWORK;
use crate::steps::{Amendment, Reading};

/// How the global memory of the fragment lists is managed (section 4, figure 4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Manager {
    /// Fixed Fragment Buffer: every pixel has room for as many records as the deepest pixel needs.
    Ffb,
    /// Dynamic Fragment Buffer: every pixel has the room that it needs, at a base offset that a prefix scan finds.
    Dfb,
    /// Per-Pixel Linked Lists in one pool of nodes. [`Fill::Atomics`] takes nodes in the order of the fragments.
    /// [`Fill::Ordered`] puts a pixel's nodes side by side.
    #[default]
    Ppll,
}

/// The sort of a Local Array. The result does not depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ArraySort {
    /// The quicker one: insertion if most pixels have few fragments, otherwise a network. In a small image a network is not
    /// worth its compiling, which takes llvmpipe seconds.
    #[default]
    Automatic,
    /// Comparisons that are fixed beforehand, written out with constant indices: Batcher's network, and in ppDP an
    /// insertion that looks at every element. Arrays over [`LARGEST_NETWORK`] are sorted by insertion.
    Network,
    /// Insertion sort, as the paper has it.
    Insertion,
}

/// How fragments find their places in the lists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Fill {
    /// Framebuffer fetch where the driver has it, otherwise atomics.
    #[default]
    Automatic,
    /// Image atomics, as the paper has it.
    Atomics,
    /// `GL_EXT_shader_framebuffer_fetch`: a pixel's fragments take their turns, without atomics. Linked lists then find
    /// their nodes by DFB's base offsets, because pixels that share no counter cannot share a pool.
    Ordered,
}

/// The fragments that a full Local Array keeps if nothing peels the rest, which is so with a static array and with ppAO
/// alone.
///
/// The paper leaves this open: "all fragments beyond this number are discarded" (section 4, Managing Local GPU Caches),
/// but it does not say in which order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Keep {
    /// The first fragments of the list as it is walked. FFB and DFB keep the fragments that came first. PPLL's lists
    /// begin at their newest node, so it keeps the fragments that came last. Fragments come in the order of submission
    /// by [`Fill::Ordered`]; by [`Fill::Atomics`] they come in the driver's order, which on llvmpipe is the same.
    #[default]
    First,
    /// The nearest fragments, and of equal depths those submitted first. The whole list is read, and in a full array a
    /// nearer fragment takes the place of the farthest. The result is the same with every manager and every fill.
    Nearest,
}

/// The format of a record's colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RecordColor {
    /// Four 16-bit floats, as the paper has it: records of 16 bytes.
    #[default]
    Half,
    /// Four 32-bit floats: records of 32 bytes.
    Float,
    /// Four fixed-point numbers of 24 bits, from 0 to 1, three bytes of them in the place of the id: records of 16 bytes.
    /// They are off by 3e-8 at most. Only for surfaces whose colours are from 0 to 1, and where fragments come in the order of
    /// submission ([`Fill::Ordered`]), because no id says it.
    Fixed,
}

impl RecordColor {
    /// The bytes of a record with such a colour, without its link.
    pub(super) const fn record_bytes(self) -> u64 {
        match self {
            Self::Half | Self::Fixed => 16,
            Self::Float => 32,
        }
    }
}

/// Options of A-buffers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ABufferOptions {
    /// The manager of the global memory.
    pub manager: Manager,
    /// per-pixel Array Optimization: a program for each complexity segment 8, 16, 32 ... `array`.
    pub pp_ao: bool,
    /// per-pixel Depth Peeling: fragments that do not fit into the Local Array are taken in another subpass. With ppAO,
    /// only the last segment peels, with an array of `array`. Without ppAO every pixel does, with an array of `peel`.
    pub pp_dp: bool,
    /// N, the size of the static Local Array, and of ppAO's last segment. It is 1 to 256, and with ppAO a power of two
    /// of at least 8. 64 is "a number often reported in the literature".
    pub array: u32,
    /// n, the size of ppDP's Local Array, 1 to 64. The paper finds 8 the fastest.
    pub peel: u32,
    /// The most subpasses that ppDP takes for a pixel. The fragments behind them are lost, and counted; the nearest
    /// ones, as many as fit into so many Local Arrays, are blended right (section 8: "guaranteeing a minimum number of
    /// correctly blended samples"). With `None` there is no limit.
    pub most_subpasses: Option<u32>,
    /// The sort of Local Arrays.
    pub sort: ArraySort,
    /// The way in which lists are filled.
    pub fill: Fill,
    /// The format of records' colours.
    pub color: RecordColor,
    /// The fragments that a full array keeps. It cannot be chosen with ppDP, which drops none.
    pub keep: Keep,
    /// A ray ends when less light than this comes through, 0 to 1. 0, the default, is exact; the paper has 0.02.
    pub termination: f32,
    /// The most bytes that fragment lists may take, including the base offsets of all pixels. An image that needs more
    /// is rendered in horizontal bands. With `None`, the lists take as much as the driver has room for and renders
    /// quickly.
    pub budget: Option<u64>,
    /// How the paper's text is read. Without amendments ppAO is masked by the stencil buffer, and ppDP goes by depth
    /// alone. Literally, ppDP waits for as many fragments as the list has, and is given up if some were lost.
    pub reading: Reading,
    /// For FFB, the number of fragments that every pixel has room for. The image is then drawn once, and the Fill Step
    /// counts (section 5.1: "no additional rendering passes are required"); what a pixel has no room for is lost, and
    /// counted. With `None`, a pass of its own counts the fragments first, and there is room for all of them.
    pub fixed_layers: Option<u32>,
    /// More amendments to the listings that run, to try the effect of a changed word. They go before the method's own.
    pub amendments: &'static [Amendment],
}

impl ABufferOptions {
    /// The defaults, as a constant.
    pub const DEFAULT: Self = Self {
        manager: Manager::Ppll,
        pp_ao: false,
        pp_dp: false,
        array: 64,
        peel: 8,
        most_subpasses: None,
        keep: Keep::First,
        sort: ArraySort::Automatic,
        fill: Fill::Automatic,
        color: RecordColor::Half,
        termination: 0.0,
        budget: None,
        reading: Reading::Amended,
        fixed_layers: None,
        amendments: &[],
    };

    /// Whether the text runs without amendments.
    pub(super) fn is_printed(&self) -> bool {
        self.reading != Reading::Amended
    }

    /// The bytes of a record with its link to the next.
    pub fn record_bytes(&self) -> u64 {
        let record = self.color.record_bytes();
        match self.manager {
            Manager::Ppll => record + 4,
            Manager::Ffb | Manager::Dfb => record,
        }
    }

    /// Whether a pixel's records begin at a base offset. An automatic fill counts as an ordered one.
    pub(super) fn has_offsets(&self) -> bool {
        match (self.manager, self.fill) {
            (Manager::Ffb, _) | (Manager::Ppll, Fill::Atomics) => false,
            (Manager::Dfb | Manager::Ppll, _) => true,
        }
    }

    /// The sizes of ppAO's segments: 8, 16, 32 ... `array`.
    pub fn segments(&self) -> impl Iterator<Item = u32> + use<> {
        let last = self.array;
        std::iter::successors(Some(SMALLEST_SEGMENT), |size| Some(size * 2))
            .take_while(move |&size| size <= last)
    }
}

/// ppAO's first segment.
pub(super) const SMALLEST_SEGMENT: u32 = 8;

impl Default for ABufferOptions {
    fn default() -> Self {
        Self::DEFAULT
    }
}
