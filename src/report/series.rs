//! Figure 2 of Lindholm et al. 2015: depth complexity histograms along a camera path, and lines of the frames' costs.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;

use super::canvas::{Drawing, Drawn, FAMILY, both};
use super::{Plot, save_text};
use crate::error::Result;
use crate::methods::Complexity;

/// A frame of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The frame's number, which is its place along the axis.
    pub frame: u32,
    /// For each of the [`BINS`], the part of all pixels whose complexity falls into it, 0 to 1.
    pub parts: [f64; BINS.len()],
    /// The values of the lines, in the series' order of names.
    pub values: Vec<f64>,
}

/// The highest complexity of each bin. A bin begins after the one before it, the first at 1.
pub const BINS: [u32; 5] = [4, 8, 16, 32, u32::MAX];

const SIZE: (u32, u32) = (1100, 560);
/// The bins' colours, darker for more layers.
const BARS: [RGBColor; BINS.len()] = [
    RGBColor(0xD6, 0xE4, 0xF0),
    RGBColor(0xA6, 0xC5, 0xE0),
    RGBColor(0x6B, 0x9E, 0xCB),
    RGBColor(0x2B, 0x5C, 0x8A),
    RGBColor(0x10, 0x2A, 0x43),
];
const LINES: [RGBColor; 3] = [
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x00, 0x9E, 0x73),
    RGBColor(0x20, 0x20, 0x20),
];

impl Moment {
    /// The moment of a frame with this complexity.
    pub fn new(frame: u32, complexity: &Complexity, values: Vec<f64>) -> Self {
        let all = complexity.counts.len().max(1) as f64;
        let mut low = 1;
        let parts = BINS.map(|high| {
            let counts = complexity.counts.iter();
            let within = counts
                .filter(|&&count| low <= count && count <= high)
                .count();
            low = high.saturating_add(1);
            within as f64 / all
        });
        Self {
            frame,
            parts,
            values,
        }
    }
}

/// The series as an SVG, and in pixels, with stacked bars on the left axis and up to three lines on the right one.
///
/// # Errors
/// If the plotting library fails.
pub fn series(caption: &str, names: &[&str], moments: &[Moment]) -> Result<[Plot; 2]> {
    let chart = Chart {
        caption,
        names,
        moments,
    };
    let (svg, picture) = both(SIZE, &chart)?;
    Ok([Plot::Svg(svg), Plot::Png(picture)])
}

/// The series' numbers as CSV: a line of names, then a line for each moment.
pub fn series_csv(names: &[&str], moments: &[Moment]) -> String {
    let mut text = format!(
        "frame,up_to_4,up_to_8,up_to_16,up_to_32,more,{}\n",
        names.join(",")
    );
    for Moment {
        frame,
        parts,
        values,
    } in moments
    {
        let numbers = parts
            .iter()
            .chain(values)
            .map(|value| format!("{value:.6}"));
        let numbers: Vec<String> = numbers.collect();
        text += &format!("{frame},{}\n", numbers.join(","));
    }
    text
}

/// Writes the numbers.
///
/// # Errors
/// If the file cannot be written.
pub fn save_series_csv(path: &Path, names: &[&str], moments: &[Moment]) -> Result<()> {
    save_text(path, &series_csv(names, moments))
}

struct Chart<'c> {
    caption: &'c str,
    names: &'c [&'c str],
    moments: &'c [Moment],
}

impl Drawing for Chart<'_> {
    const WHAT: &'static str = "the series";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let Self {
            caption,
            names,
            moments,
        } = *self;
        let step = match moments {
            [first, second, ..] => f64::from(second.frame.saturating_sub(first.frame)).max(1.0),
            _ => 1.0,
        };
        let end = moments
            .last()
            .map_or(1.0, |moment| f64::from(moment.frame) + step);
        let values = moments.iter().flat_map(|moment| &moment.values);
        let top = values.copied().fold(0.0, f64::max).max(1e-9) * 1.65;
        let covered = moments
            .iter()
            .map(|moment| moment.parts.iter().sum::<f64>());
        // The upper two fifths are for the legend.
        let left = (covered.fold(0.0, f64::max) * 165.0).max(1e-9);
        let mut chart = ChartBuilder::on(area)
            .caption(caption, (FAMILY, 24))
            .margin(16)
            .x_label_area_size(48)
            .y_label_area_size(64)
            .right_y_label_area_size(64)
            .build_cartesian_2d(0.0..end, 0.0..left)?
            .set_secondary_coord(0.0..end, 0.0..top);
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .x_desc("frame")
            .y_desc("pixels, %")
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .x_label_formatter(&|x| format!("{x:.0}"))
            // Above 100 there is nothing but the legend.
            .y_label_formatter(&|&y| {
                if y > 100.0 {
                    String::new()
                } else {
                    format!("{y:.0}")
                }
            })
            .draw()?;
        chart
            .configure_secondary_axes()
            .y_desc("lines, frame 0 = 1")
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .y_label_formatter(&|y| format!("{y:.1}"))
            .draw()?;
        for (bin, color) in BARS.into_iter().enumerate() {
            let bars = moments.iter().map(|moment| {
                let below: f64 = moment.parts[..bin].iter().sum();
                let x = f64::from(moment.frame);
                let ends = [(x, below), (x + 0.85 * step, below + moment.parts[bin])];
                Rectangle::new(ends.map(|(x, y)| (x, y * 100.0)), color.filled())
            });
            let label = match BINS[bin] {
                u32::MAX => format!("more than {} layers", BINS[bin - 1]),
                high => format!("up to {high}"),
            };
            chart.draw_series(bars)?.label(label).legend(move |(x, y)| {
                Rectangle::new([(x, y - 6), (x + 18, y + 6)], color.filled())
            });
        }
        for (n, (name, color)) in names.iter().zip(LINES).enumerate() {
            let point = |moment: &Moment| (f64::from(moment.frame) + 0.4 * step, moment.values[n]);
            chart
                .draw_secondary_series([PathElement::new(
                    moments.iter().map(point).collect::<Vec<_>>(),
                    color.stroke_width(3),
                )])?
                .label(*name)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 18, y)], color.stroke_width(3))
                });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.85))
            .label_font((FAMILY, 16))
            .draw()?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moment_puts_every_covered_pixel_into_one_bin() {
        let complexity = Complexity {
            width: 8,
            height: 1,
            counts: vec![0, 1, 4, 5, 16, 17, 32, 33],
        };
        let moment = Moment::new(3, &complexity, vec![2.0]);
        assert_eq!(moment.parts, [0.25, 0.125, 0.125, 0.25, 0.125]);
        let csv = series_csv(&["time"], std::slice::from_ref(&moment));
        assert!(
            csv.ends_with("\n3,0.250000,0.125000,0.125000,0.250000,0.125000,2.000000\n"),
            "{csv}"
        );
        let [svg, _] = series("test", &["time"], &[moment]).unwrap();
        let Plot::Svg(text) = svg else {
            panic!("not an SVG")
        };
        assert!(
            text.contains("#102A43") && text.contains("#D55E00"),
            "{text}"
        );
    }
}
