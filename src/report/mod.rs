//! What goes onto paper: pictures, plots, tables.

mod bars;
mod canvas;
mod complexity;
mod convergence;
mod histogram;
mod series;

pub use bars::{BarGroup, bars};
pub use complexity::{csv, picture};
pub use convergence::{Curves, convergence};
pub use histogram::{Plot, PlotKind, plot};
pub use series::{BINS, Moment, save_series_csv, series, series_csv};

use std::path::Path;

/// Writes a text; the file appears only when it is whole.
///
/// # Errors
/// If it cannot be written.
pub fn save_text(path: &Path, text: &str) -> crate::error::Result<()> {
    crate::image::write_whole(path, text.as_bytes())
}
