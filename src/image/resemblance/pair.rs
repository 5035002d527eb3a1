//! Two pictures, and a mistake that has been tried on them.

use crate::fragment::Rgba;
use crate::image::Image;

/// Two pictures of the same size, and the largest difference at which two pixels have the same colour.
pub(super) struct Pair<'a> {
    pub(super) image: &'a Image,
    pub(super) exact: &'a Image,
    pub(super) tolerance: f32,
}

/// A mistake that was tried.
pub(super) struct Tried {
    /// The number of pixels that still differ, among those about which the rule says anything.
    pub(super) left: usize,
    pub(super) sentence: String,
}

impl Pair<'_> {
    /// The number of pixels that differ from the rule applied to the exact ones.
    pub(super) fn left(&self, rule: impl Fn(&Rgba) -> Rgba) -> usize {
        let pixels = self.image.pixels.iter().zip(&self.exact.pixels);
        pixels
            .filter(|(image, exact)| !self.same(image, &rule(exact)))
            .count()
    }

    /// Whether two pixels have the same colour. A value that is not a number is not the same as any other.
    pub(super) fn same(&self, a: &Rgba, b: &Rgba) -> bool {
        let near = |a: f32, b: f32| a == b || (a - b).abs() <= self.tolerance;
        near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b) && near(a.a, b.a)
    }
}

impl Tried {
    pub(super) fn new(left: usize, sentence: impl Into<String>) -> Self {
        Self {
            left,
            sentence: sentence.into(),
        }
    }
}
