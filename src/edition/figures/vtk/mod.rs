//! VTK's two options.

mod peels;
mod ratio;

use super::figure::Figure;

pub(super) const FIGURES: &[Figure] = &[peels::FIGURE, ratio::FIGURE];
