//! The depth complexity histogram as a plot, with pixels on a logarithmic axis (Lindholm et al. 2015, figure 1e).

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::canvas::{Drawing, Drawn, FAMILY, both};
use super::save_text;
use crate::error::{Error, Result};
use crate::image::Image;
use crate::methods::{Bin, Complexity};

/// A kind of plot file, as the ending of its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlotKind {
    /// `.svg`: lines and text.
    Svg,
    /// `.png`: pixels.
    Png,
}

impl PlotKind {
    /// The kind of a file, by its name.
    ///
    /// # Errors
    /// If the name has neither ending.
    pub fn of(path: &Path) -> Result<Self> {
        let ending = path.extension().and_then(|ending| ending.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            _ => Err(Error::FileName {
                path: path.to_owned(),
                kind: "plot",
                remedy: "name it .svg or .png",
            }),
        }
    }
}

/// A plot that is ready to be written. Nothing will be added: a caller writes each kind in a way of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Plot {
    /// An SVG's text.
    Svg(String),
    /// Pixels.
    Png(Image),
}

const SIZE: (u32, u32) = (900, 560);
const BAR: RGBColor = RGBColor(0x2B, 0x5C, 0x8A);

/// Plots the histogram with bins of `bin` complexities. Pixels without a fragment are left out, and the caption says
/// how many they are.
///
/// # Errors
/// If the plotting library fails.
pub fn plot(name: &str, complexity: &Complexity, bin: u32, kind: PlotKind) -> Result<Plot> {
    let caption = format!(
        "{name}: {} of {} pixels covered, at most {} layers",
        complexity.covered(),
        complexity.counts.len(),
        complexity.max()
    );
    let chart = Chart {
        caption,
        bins: covered_bins(complexity, bin),
    };
    let (svg, picture) = both(SIZE, &chart)?;
    Ok(match kind {
        PlotKind::Svg => Plot::Svg(svg),
        PlotKind::Png => Plot::Png(picture),
    })
}

impl Plot {
    /// Writes the plot. The file appears only when it is whole.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, path: &Path) -> Result<()> {
        match self {
            Self::Png(image) => image.save(path),
            Self::Svg(text) => save_text(path, text),
        }
    }
}

/// Writes an SVG or a PNG, as the file's name says.
pub(super) fn save_either(path: &Path, draw: impl FnOnce() -> Result<[Plot; 2]>) -> Result<()> {
    let kind = PlotKind::of(path)?;
    let [svg, png] = draw()?;
    match kind {
        PlotKind::Svg => svg.save(path),
        PlotKind::Png => png.save(path),
    }
}

/// The bins. Pixels without a fragment are taken out of the first.
fn covered_bins(complexity: &Complexity, bin: u32) -> Vec<Bin> {
    let mut bins = complexity.histogram(bin);
    let empty = complexity.counts.len() as u64 - complexity.covered();
    bins[0].pixels -= empty;
    bins
}

struct Chart {
    caption: String,
    bins: Vec<Bin>,
}

impl Drawing for Chart {
    const WHAT: &'static str = "the histogram";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let Self { caption, bins } = self;
        let most = bins.iter().map(|bin| bin.pixels).max().unwrap_or(1).max(1);
        let right = bins.last().map_or(1, |bin| bin.to + 1);
        // A bar of one pixel must be visible, so the axis begins below 1.
        let rows = (0.5..most as f64 * 1.5).log_scale();
        let mut chart = ChartBuilder::on(area)
            .caption(caption, (FAMILY, 24))
            .margin(16)
            .x_label_area_size(48)
            .y_label_area_size(80)
            .build_cartesian_2d(0.0..f64::from(right), rows)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.15))
            .x_desc("depth complexity")
            .y_desc("pixels")
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .x_label_formatter(&|x| format!("{x:.0}"))
            .y_label_formatter(&|y| format!("{y:.0}"))
            .draw()?;
        let bars = bins.iter().filter(|bin| bin.pixels > 0).map(|bin| {
            // On either side of a bar there is a gap of a tenth of its width.
            let width = f64::from(bin.to - bin.from + 1);
            let left = f64::from(bin.from) + 0.1 * width;
            let corners = [(left, 0.5), (left + 0.8 * width, bin.pixels as f64)];
            Rectangle::new(corners, BAR.filled())
        });
        chart.draw_series(bars)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fragment::Rgba;

    fn complexity() -> Complexity {
        Complexity {
            width: 5,
            height: 1,
            counts: vec![0, 0, 2, 2, 4],
        }
    }

    #[test]
    fn there_is_a_bar_for_each_bin_that_has_pixels() {
        let Plot::Svg(text) = plot("test", &complexity(), 1, PlotKind::Svg).unwrap() else {
            panic!("not an SVG");
        };
        assert_eq!(text.matches("#2B5C8A").count(), 2, "{text}");
        assert!(text.contains("3 of 5 pixels covered, at most 4 layers"));
    }

    #[test]
    fn a_plot_in_pixels_has_bars_and_text() {
        let Plot::Png(image) = plot("test", &complexity(), 1, PlotKind::Png).unwrap() else {
            panic!("not pixels");
        };
        let bar = Rgba::opaque([0x2B, 0x5C, 0x8A].map(|c: u8| f32::from(c) / 255.0));
        assert!(image.pixels.iter().filter(|&&pixel| pixel == bar).count() > 10_000);
        // Text at the top, where the caption is.
        let dark = |pixel: &&Rgba| pixel.r < 0.5;
        assert!(image.pixels[..900 * 50].iter().filter(dark).count() > 100);
    }

    #[test]
    fn an_image_without_fragments_can_be_plotted() {
        let empty = Complexity {
            width: 1,
            height: 1,
            counts: vec![0],
        };
        plot("nothing", &empty, 8, PlotKind::Svg).unwrap();
    }
}
