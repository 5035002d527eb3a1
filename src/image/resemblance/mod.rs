//! Recognising a difference: the usual mistakes in writing pictures, each of them tried.
//!
//! A mistake is a rule that makes a wrong picture from the exact one, pixel by pixel: `image = rule(exact)`. To try a
//! rule, it is applied to the exact picture, and the pixels that still differ are counted. Among the rules that explain
//! nearly every differing pixel, the one that explains most is reported. If two explain the same number, the simpler
//! one is.

mod background;
mod colors;
mod pair;
mod places;

use std::fmt;

use super::Image;
use pair::{Pair, Tried};

/// The mistake that a difference looks like.
#[derive(Clone, Debug, PartialEq)]
pub struct Resemblance {
    /// A sentence or two: the mistake, and what to do about it.
    pub sentence: String,
    /// The part of the differing pixels that it explains, more than [`NEARLY_ALL`] and at most 1.
    pub explains: f64,
}

/// A rule must explain at least this part of the differing pixels. It is less than 1 because other rasterisers may also
/// differ at silhouettes.
pub const NEARLY_ALL: f64 = 0.9;

/// Half a step of 8 bits, which rounding may add to a difference that the bound allows.
const ROUNDING: f64 = 0.5 / 255.0;

/// The mistake that explains the difference between an image and the exact one over `background` (linear RGB). `None`
/// if no pixel differs by more than `bound` and rounding, or if no known mistake explains nearly all differing pixels.
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
            // Rounded down, so that it says 'all' only if it is all.
            let percent = (self.explains * 100.0).floor();
            write!(f, " (This explains {percent} % of the pixels that differ.)")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
