//! What there is to know about a method before it runs.

use std::fmt;

use crate::gl::Driver;

/// What there is to know about a method before it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its name on the command line.
    pub name: &'static str,
    /// Where it is published.
    pub source: &'static str,
    /// Whether its image is exact when nothing stops it early, but for the rounding of the colours it keeps: of surfaces.
    pub exact: bool,
    /// Whether it is exact, of surfaces and of volumes, in words, with what limits it.
    pub exactness: &'static str,
    /// What becomes of fragments of equal depth.
    pub ties: Ties,
    /// What its memory grows with.
    pub memory: Memory,
    /// Whether and how it renders volumes.
    pub volumes: Volumes,
    /// What it keeps of a pixel that has more fragments than its array has room for ([`Keep`](super::Keep)), or `None` if
    /// it has no array that could be too small.
    pub keeps: Option<&'static str>,
    /// Extensions beyond OpenGL 4.3 of which it needs one; empty if it needs none.
    pub needs: &'static [&'static str],
}

impl Entry {
    /// Whether a driver offers what it needs.
    pub fn runs_on(&self, driver: &Driver) -> bool {
        self.needs.is_empty() || self.needs.iter().any(|extension| driver.has(extension))
    }

    /// Whether it is exact of volumes, too: a ray takes the samples that the oracle's takes, while slices have an error of
    /// order 1 in their distance. `None` if it renders no volumes.
    pub fn exact_volumes(&self) -> Option<bool> {
        match self.volumes {
            Volumes::Refused => None,
            Volumes::SlicesWhenAsked | Volumes::Slices => Some(false),
            Volumes::Rays => Some(self.exact),
        }
    }
}

pub(super) const EXACT_BUT_NOT_SLICES: &str =
    "yes; volumes as slices: no, an error of order 1 in the slices' distance";
pub(super) const EXACT_BY_RAYS: &str = "yes, volumes by rays, too";

/// What becomes of fragments of one pixel that have exactly the same depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ties {
    /// All are in the image, what was submitted first in front.
    InOrder,
    /// All are in the image, each over those drawn before it.
    OverEarlier,
    /// All are in the image, in the order in which they are drawn after sorting.
    InOrderAfterSorting,
    /// All are in the image, those of unsorted meshes in front.
    UnsortedFirst,
    /// The first submitted is in the image; the others are lost, and counted.
    FirstKept,
    /// All are in the image, and their order makes no difference to it.
    Unordered,
}

impl fmt::Display for Ties {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::InOrder => "order of submission",
            Self::OverEarlier => "each over those drawn before it",
            Self::InOrderAfterSorting => "order of submission after sorting",
            Self::UnsortedFirst => "unsorted meshes before sorted ones",
            Self::FirstKept => "the first submitted, the others lost and counted",
            Self::Unordered => "no order",
        })
    }
}

/// What a method's memory grows with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Memory {
    /// The image's pixels.
    Pixels,
    /// The image's pixels, and the triangles, whose order is kept.
    PixelsAndTriangles,
    /// The image's pixels, or pixels times layers if layers are kept.
    PixelsOrLayers,
    /// Pixels times the layers of the deepest pixel, in bands of the image.
    PixelsTimesLayers,
    /// Pixels, and the fragments of all pixels, in bands of the image.
    PixelsAndFragments,
    /// The fragments of all pixels, in pieces of the image.
    Fragments,
}

impl fmt::Display for Memory {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Pixels => "pixels",
            Self::PixelsAndTriangles => "pixels + triangles",
            Self::PixelsOrLayers => "pixels (layers x pixels if they are kept)",
            Self::PixelsTimesLayers => "pixels x layers, in bands",
            Self::PixelsAndFragments => "pixels + fragments, in bands",
            Self::Fragments => "fragments, in pieces",
        })
    }
}

/// Whether and how a method renders volumes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Volumes {
    /// Not at all: scenes with volumes are refused.
    Refused,
    /// As slices, if it is asked to ([`Renderer::with_slices`](super::Renderer::with_slices)); otherwise scenes with
    /// volumes are refused.
    SlicesWhenAsked,
    /// As slices, asked or not.
    Slices,
    /// By rays through them.
    Rays,
}

impl Volumes {
    /// Whether they are rendered without anybody asking for slices.
    pub const fn are_rendered(self) -> bool {
        matches!(self, Self::Slices | Self::Rays)
    }

    /// Whether they can be drawn as slices: by whatever draws surfaces in an order that is more than that of submission.
    pub const fn take_slices(self) -> bool {
        matches!(self, Self::Slices | Self::SlicesWhenAsked)
    }
}
