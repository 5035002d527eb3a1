//! In which order parallel surfaces are submitted.

use crate::scene::chance::Chance;

/// An order of submission, for an eye on the +z side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    /// The nearest first. Of two at the same depth the one with the smaller number first.
    FrontToBack,
    /// The exact reverse of that, which blending without any sorting draws correctly.
    #[default]
    BackToFront,
    /// As the seed decides.
    Shuffled,
}

impl Order {
    /// The numbers of the surfaces at these depths (a larger depth is further away) in the order of submission.
    pub(super) fn of(self, depths: &[f32], seed: u64) -> Vec<usize> {
        let mut numbers: Vec<usize> = (0..depths.len()).collect();
        // Stable, so that equal depths stay in their order.
        numbers.sort_by(|&a, &b| depths[a].total_cmp(&depths[b]));
        match self {
            Self::FrontToBack => {}
            Self::BackToFront => numbers.reverse(),
            Self::Shuffled => Chance::new(seed).shuffle(&mut numbers),
        }
        numbers
    }
}
