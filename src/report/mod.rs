//! Reports: pictures, plots and tables of what was counted.

mod bars;
mod canvas;
mod complexity;
mod convergence;
mod costs;
mod histogram;
mod palette;
mod series;

pub use bars::{BarGroup, bars};
pub use complexity::{csv, picture};
pub use convergence::{Curves, convergence};
pub use costs::{CostLine, costs};
pub use histogram::{Plot, PlotKind, plot};
pub use series::{BINS, Moment, save_series_csv, series, series_csv};

use std::path::Path;

/// Writes a text. The file appears only when it is whole.
///
/// # Errors
/// If the file cannot be written.
pub fn save_text(path: &Path, text: &str) -> crate::error::Result<()> {
    crate::image::write_whole(path, text.as_bytes())
}
