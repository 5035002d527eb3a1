//! The reports' drawings, as pages have them.

use super::Studio;
use crate::low_level::report::Plot;

/// The SVG of a drawing that comes as SVG and in pixels.
pub(super) fn svg_of(plots: [Plot; 2]) -> String {
    let mut texts = plots.into_iter().map(svg_of_plot);
    texts.find(|text| !text.is_empty()).unwrap_or_default()
}

/// The SVG's text. Empty if the plot is in pixels.
pub(super) fn svg_of_plot(plot: Plot) -> String {
    match plot {
        Plot::Svg(text) => text,
        Plot::Png(_) => String::new(),
    }
}

/// What was timed, and on which driver. Times are ratios of one run, and only the whole edition has them.
pub(super) fn times_taken_on(what: &str, studio: &Studio) -> String {
    format!("{what} (one run on {})", studio.context.driver().renderer)
}
