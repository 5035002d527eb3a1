//! The figures of Carr, Měch and Miller 2008.

mod buffers;
mod figure_1;
pub mod figure_2;
pub mod figure_3;
mod ideal;
mod iterations;
mod models;
mod order;
mod painter;
mod section_6;
mod slices_and_cone;
mod sorting;
pub mod table_1;

pub use ideal::rows as ideal_rows;
pub use slices_and_cone::with_slices;

use super::Figure;

/// In the paper's order.
pub(super) const FIGURES: &[Figure] = &[
    painter::FIGURE,
    figure_1::FIGURE,
    iterations::HYBRID,
    order::FIGURE,
    figure_2::FIGURE,
    buffers::PASS[0],
    buffers::PASS[1],
    buffers::PASS[2],
    buffers::PASS[3],
    buffers::PASS[4],
    buffers::PASS[5],
    buffers::FIGURE,
    iterations::COHERENT,
    section_6::FIGURE,
    ideal::FIGURE,
    figure_3::FIGURE,
    models::FIGURE_4,
    models::FIGURE_5,
    table_1::FIGURE,
    sorting::FIGURE,
];
