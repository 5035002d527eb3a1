//! The figures of Lindholm et al. 2015.

pub mod figure_2;
mod figure_3;
pub mod figure_4;
pub mod figure_5;
mod figure_6;
mod figure_7;
mod fog;
mod left;
mod ray;
mod segments;
mod table_1;
mod views;

pub use fog::{InSlices, slices_against_rays};
pub use ray::two_volumes as ray_through_two_volumes;
pub use table_1::SCENES;

use super::Figure;

/// In the paper's order.
pub(super) const FIGURES: &[Figure] = &[
    views::FIGURE_1,
    figure_2::FIGURE,
    figure_3::FIGURE,
    figure_4::FIGURE,
    figure_5::FIGURE,
    segments::FIGURE,
    ray::FIGURE,
    fog::FIGURE,
    table_1::FIGURE,
    views::FIGURE_8,
    views::FIGURE_9,
    views::FIGURE_10,
    figure_6::FIGURE,
    figure_7::FIGURE,
];
