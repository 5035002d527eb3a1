//! What a difference looks like: the mistakes that are made when pictures are written, each of them tried.
//!
//! A mistake is a rule that makes a wrong picture of the exact one, pixel by pixel: `image = rule(exact)`. It is tried by
//! applying it and counting the pixels that it leaves over. Of all rules that explain nearly every pixel that differs, the
//! one that explains most is said; the plainer one, if they explain as much.

mod background;
mod colors;
mod places;

use std::fmt;

use super::Image;
use crate::fragment::Rgba;

/// What a difference looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Resemblance {
    /// A sentence or two: what is the matter, and what to do.
    pub sentence: String,
    /// Which part of the pixels that differ it explains, more than [`NEARLY_ALL`] and up to 1.
    pub explains: f64,
}

/// A rule must explain at least this part of the differing pixels: at silhouettes other rasterisers may differ, too.
pub const NEARLY_ALL: f64 = 0.9;

/// Half a step of 8 bits: what rounding adds to a difference that the bound allows.
const ROUNDING: f64 = 0.5 / 255.0;

/// Two pictures of one size, and how far apart pixels of one colour may be.
struct Pair<'a> {
    image: &'a Image,
    exact: &'a Image,
    tolerance: f32,
}

/// A mistake that has been tried.
struct Tried {
    /// Pixels that differ with it, of those that it says anything about.
    left: usize,
    sentence: String,
}

/// What the difference between an image and the exact one over `background` (linear RGB) looks like; nothing if no pixel
/// differs by more than `bound` and rounding, or no mistake that is known here explains nearly all that do.
///
/// # Panics
/// If the pictures differ in size.
pub fn resemblance(
    image: &Image,
    exact: &Image,
    bound: f64,
    background: [f32; 3],
) -> Option<Resemblance> {
    assert_eq!(
        [image.width, image.height],
        [exact.width, exact.height],
        "pictures of one size"
    );
    let pair = Pair {
        image,
        exact,
        tolerance: (bound + ROUNDING) as f32,
    };
    let differing = pair.left(|&exact| exact);
    if differing == 0 {
        return None;
    }
    let enough = ((1.0 - NEARLY_ALL) * differing as f64) as usize;
    let mut best: Option<Tried> = None;
    let of_colors = colors::tried(&pair).into_iter();
    let of_background = background::tried(&pair, background);
    let all = of_colors.chain(of_background).chain(places::tried(&pair));
    for tried in all {
        let limit = best.as_ref().map_or(enough + 1, |best| best.left);
        if tried.left < limit {
            best = Some(tried);
        }
    }
    let Tried { left, sentence } = best?;
    Some(Resemblance {
        sentence,
        explains: 1.0 - left as f64 / differing as f64,
    })
}

impl fmt::Display for Resemblance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence)?;
        if self.explains < 1.0 {
            // Rounded down, so that it never says all of what is not all.
            let percent = (self.explains * 100.0).floor();
            write!(f, " (This explains {percent} % of the pixels that differ.)")?;
        }
        Ok(())
    }
}

impl Pair<'_> {
    /// How many pixels differ from what a rule makes of the exact ones.
    fn left(&self, rule: impl Fn(&Rgba) -> Rgba) -> usize {
        let pixels = self.image.pixels.iter().zip(&self.exact.pixels);
        pixels
            .filter(|(image, exact)| !self.same(image, &rule(exact)))
            .count()
    }

    /// Whether two pixels are of one colour. What is not a number is like nothing.
    fn same(&self, a: &Rgba, b: &Rgba) -> bool {
        let near = |a: f32, b: f32| a == b || (a - b).abs() <= self.tolerance;
        near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b) && near(a.a, b.a)
    }
}

impl Tried {
    fn new(left: usize, sentence: impl Into<String>) -> Self {
        Self {
            left,
            sentence: sentence.into(),
        }
    }
}

#[cfg(test)]
mod tests;
