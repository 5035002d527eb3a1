//! The facts about a method that are known before it runs.

use std::fmt;

use crate::gl::Driver;

/// The facts about a method that are known before it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Entry {
    /// The method's name on the command line.
    pub name: &'static str,
    /// The publication.
    pub source: &'static str,
    /// Whether its image of surfaces is exact if nothing stops it early, up to the rounding of stored colours.
    pub exact: bool,
    /// Whether it is exact for surfaces and for volumes, in words, with its limits.
    pub exactness: &'static str,
    /// The order of fragments of equal depth.
    pub ties: Ties,
    /// The quantities with which its memory grows.
    pub memory: Memory,
    /// Whether and how it renders volumes.
    pub volumes: Volumes,
    /// The fragments that a full array keeps ([`Keep`](super::Keep)), or `None` if it has no array that could be too
    /// small.
    pub keeps: Option<&'static str>,
    /// Extensions beyond OpenGL 4.3. The method needs one of them, or none if the list is empty.
    pub needs: &'static [&'static str],
}

impl Entry {
    /// An entry of a method of one's own, whose fields can then be set: it is not exact, has fragments of equal depth in
    /// the order of submission, takes memory for pixels, refuses volumes, and needs no extension.
    pub const fn new(name: &'static str, source: &'static str) -> Self {
        Self {
            name,
            source,
            exact: false,
            exactness: "no",
            ties: Ties::InOrder,
            memory: Memory::Pixels,
            volumes: Volumes::Refused,
            keeps: None,
            needs: &[],
        }
    }

    /// Whether the method runs on a driver.
    pub fn runs_on(&self, driver: &Driver) -> bool {
        self.needs.is_empty() || self.needs.iter().any(|extension| driver.has(extension))
    }

    /// Whether it is exact for volumes. A ray takes the same samples as the oracle's, while slices have an error of
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

/// The order of fragments of a pixel that have exactly the same depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ties {
    /// All are in the image. The one submitted first lies in front.
    InOrder,
    /// All are in the image, each over those drawn before it.
    OverEarlier,
    /// All are in the image, in the order in which they are drawn after sorting.
    InOrderAfterSorting,
    /// All are in the image. Those of unsorted meshes lie in front.
    UnsortedFirst,
    /// The first submitted is in the image. The others are lost, and counted.
    FirstKept,
    /// All are in the image, which does not depend on their order.
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

/// The quantities with which a method's memory grows.
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
#[non_exhaustive]
pub enum Volumes {
    /// Not at all: scenes with volumes are refused.
    Refused,
    /// As slices, if the caller asks for them ([`Renderer::with_slices`](super::Renderer::with_slices)). Otherwise
    /// scenes with volumes are refused.
    SlicesWhenAsked,
    /// As slices, by default.
    Slices,
    /// By rays through them.
    Rays,
}

impl Volumes {
    /// Whether volumes are rendered if the caller does not ask for slices.
    pub const fn are_rendered(self) -> bool {
        matches!(self, Self::Slices | Self::Rays)
    }

    /// Whether volumes can be drawn as slices. Methods can do so that draw surfaces in another order than that of
    /// submission.
    pub const fn take_slices(self) -> bool {
        matches!(self, Self::Slices | Self::SlicesWhenAsked)
    }
}
