//! Reports: pictures, plots and tables of what was counted.

mod bars;
mod canvas;
mod complexity;
mod convergence;
mod costs;
mod cross_section;
mod fates;
mod histogram;
mod key;
mod layers;
mod local_arrays;
mod memory_layout;
mod palette;
mod panels;
mod scale;
mod series;
mod strips;

pub use bars::{BarGroup, bars};
pub use complexity::{csv, picture};
pub use convergence::{Curves, convergence};
pub use costs::{CostLine, costs};
pub use cross_section::CrossSection;
pub use fates::fates;
pub use histogram::{Plot, PlotKind, plot};
pub use layers::{depths, opaque};
pub use local_arrays::local_arrays;
pub use memory_layout::memory_layout;
pub use panels::Panels;
pub use scale::Measure;
pub use series::{BINS, Moment, save_series_csv, series, series_csv};
pub use strips::Strips;

use std::path::Path;

/// Writes a text. The file appears only when it is whole.
///
/// # Errors
/// If the file cannot be written.
pub fn save_text(path: &Path, text: &str) -> crate::error::Result<()> {
    crate::image::write_whole(path, text.as_bytes())
}
