//! The order in which parallel surfaces are submitted.

use crate::scene::chance::Chance;
use crate::words::words;

/// An order of submission, for an eye on the +z side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum SubmissionOrder {
    /// The nearest surface first. Of two surfaces at the same depth, the one with the smaller number first.
    FrontToBack,
    /// The exact reverse of front to back. Blending without any sorting draws it correctly.
    #[default]
    BackToFront,
    /// A random order, given by the seed.
    Shuffled,
}

words! { SubmissionOrder, "order of submission",
    FrontToBack "front-to-back" "The nearest surface first",
    BackToFront "back-to-front" "The farthest surface first",
    Shuffled "shuffled" "In a random order",
}

impl SubmissionOrder {
    /// The numbers of the surfaces at these depths, in the order of submission. A larger depth is further away.
    pub(super) fn of(self, depths: &[f32], seed: u64) -> Vec<usize> {
        let mut numbers: Vec<usize> = (0..depths.len()).collect();
        // The sort is stable, so that surfaces of equal depth stay in their order.
        numbers.sort_by(|&a, &b| depths[a].total_cmp(&depths[b]));
        match self {
            Self::FrontToBack => {}
            Self::BackToFront => numbers.reverse(),
            Self::Shuffled => Chance::new(seed).shuffle(&mut numbers),
        }
        numbers
    }
}
