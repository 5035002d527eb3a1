//! The figures of Everitt 2001.

mod buffers;
mod figure_1;
mod figure_2;
mod figure_3;
mod figure_4;
mod figure_5;
mod figure_6;
mod listing_2;

use super::figure::Figure;

/// In the paper's order. It calls two figures figure 5. The second of them is `everitt-6` here.
pub(super) const FIGURES: &[Figure] = &[
    figure_1::FIGURE,
    buffers::FIGURE,
    figure_2::FIGURE,
    figure_3::FIGURE,
    figure_4::FIGURE,
    figure_5::FIGURE,
    listing_2::FIGURE,
    figure_6::FIGURE,
];
