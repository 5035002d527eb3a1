//! What can be chosen about an A-buffer.

/// How the global memory of the fragment lists is managed (section 4, figure 4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Manager {
    /// Fixed Fragment Buffer: every pixel has room for as many records as the deepest pixel needs.
    Ffb,
    /// Dynamic Fragment Buffer: every pixel has the room that it needs, at a base offset that a prefix scan finds.
    Dfb,
    /// Per-Pixel Linked Lists in one pool of nodes: taken as they come by [`Fill::Atomics`], a pixel's nodes side by side
    /// by [`Fill::Ordered`].
    #[default]
    Ppll,
}

/// How a Local Array is sorted. The result is the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Sort {
    /// Whichever is quicker: insertion where most pixels have few fragments, otherwise a network.
    #[default]
    Automatic,
    /// Comparisons that are fixed beforehand, written out with constant indices: Batcher's network, and in ppDP an
    /// insertion that looks at every element. Arrays over [`LARGEST_NETWORK`] are sorted by insertion.
    Network,
    /// Insertion sort, as the paper has it.
    Insertion,
}

/// The largest array that a network sorts; larger ones take the driver too long to compile. Llvmpipe takes two seconds for 32
/// elements and six for 64.
pub const LARGEST_NETWORK: u32 = 128;

/// How fragments find their places in the lists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fill {
    /// Framebuffer fetch where the driver has it, otherwise atomics.
    #[default]
    Automatic,
    /// Image atomics, as the paper has it.
    Atomics,
    /// `GL_EXT_shader_framebuffer_fetch`: a pixel's fragments take their turns, without atomics. Linked lists then find
    /// their nodes by DFB's base offsets, for pixels that share no counter share no pool either.
    Ordered,
}

/// Which fragments a full Local Array keeps, where nothing peels the rest: with a static array, and with ppAO alone.
///
/// The paper leaves it open: "all fragments beyond this number are discarded" (section 4, Managing Local GPU Caches), but
/// beyond it in which order is not said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Keep {
    /// The first of the list as it is walked. FFB and DFB keep what came first, PPLL, whose lists begin at their newest
    /// node, what came last. Fragments come in the order of submission by [`Fill::Ordered`]; by [`Fill::Atomics`] they
    /// come as the driver runs them, which on llvmpipe is the same order.
    #[default]
    First,
    /// The nearest, and of equal depths the first submitted: the whole list is read, and in a full array a nearer
    /// fragment takes the place of the farthest. The same with every manager and every fill.
    Nearest,
}

/// How a record keeps its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum RecordColor {
    /// Four 16-bit floats, as the paper has it: records of 16 bytes.
    #[default]
    Half,
    /// Four 32-bit floats: records of 32 bytes.
    Float,
}

impl RecordColor {
    /// Bytes of a record with such a colour, its link left out.
    pub(super) const fn record_bytes(self) -> u64 {
        match self {
            Self::Half => 16,
            Self::Float => 32,
        }
    }
}

/// What can be chosen about an A-buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ABufferOptions {
    /// Global memory.
    pub manager: Manager,
    /// per-pixel Array Optimization: a program for each complexity segment 8, 16, 32 ... `array`.
    pub pp_ao: bool,
    /// per-pixel Depth Peeling: what does not fit into the Local Array is taken in another subpass. With ppAO it is the
    /// last segment that has them, with an array of `array`; without, every pixel, with an array of `peel`.
    pub pp_dp: bool,
    /// N: how many fragments the static Local Array has room for, and ppAO's last segment. 1 to 256; a power of two, and
    /// at least 8 with ppAO. 64 is "a number often reported in the literature".
    pub array: u32,
    /// n: the Local Array of ppDP, 1 to 64. The paper finds 8 the fastest.
    pub peel: u32,
    /// How Local Arrays are sorted.
    pub sort: Sort,
    /// How lists are filled.
    pub fill: Fill,
    /// How records keep colours.
    pub color: RecordColor,
    /// Which fragments an array keeps that has no room for all of its pixel's. Not with ppDP, which drops none.
    pub keep: Keep,
    /// A ray ends when less light than this comes through, 0 to 1. 0, the default, is exact; the paper has 0.02.
    pub termination: f32,
    /// The most bytes that fragment lists may take, all pixels' base offsets included. What does not fit is rendered in
    /// horizontal bands. If it is none: as many as the driver has room for and renders quickly
    /// ([`Room::quick`](super::Room::quick)).
    pub budget: Option<u64>,
    /// ppAO masked by the stencil buffer and ppDP by depth alone, with nothing amended.
    pub as_printed: bool,
}

impl ABufferOptions {
    /// The defaults, in a form that constants can be made of.
    pub const DEFAULT: Self = Self {
        manager: Manager::Ppll,
        pp_ao: false,
        pp_dp: false,
        array: 64,
        peel: 8,
        keep: Keep::First,
        sort: Sort::Automatic,
        fill: Fill::Automatic,
        color: RecordColor::Half,
        termination: 0.0,
        budget: None,
        as_printed: false,
    };

    /// Bytes of a record with what links it to the next.
    pub fn record_bytes(&self) -> u64 {
        let record = self.color.record_bytes();
        match self.manager {
            Manager::Ppll => record + 4,
            Manager::Ffb | Manager::Dfb => record,
        }
    }

    /// Whether a pixel's records lie behind a base offset. An automatic fill counts as an ordered one.
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
