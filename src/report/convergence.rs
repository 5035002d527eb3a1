//! A plot of errors that fall with a refinement, and of the refinement's costs: lines between logarithmic axes.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::canvas::{Drawing, Drawn, FAMILY, both};
use super::{Plot, palette};

use crate::error::Result;

/// A vertical axis and its curves.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// The text beside the axis.
    pub of_what: String,
    /// The curves: each has a name, and a value greater than 0 for each refinement in order. A curve may end early.
    pub curves: Vec<(String, Vec<f64>)>,
}

const SIZE: (u32, u32) = (1000, 600);
const LEFT: [RGBColor; 3] = [
    RGBColor(0x00, 0x72, 0xB2),
    RGBColor(0x10, 0x2A, 0x43),
    RGBColor(0xCC, 0x79, 0xA7),
];
const RIGHT: [RGBColor; 2] = [RGBColor(0xD5, 0x5E, 0x00), RGBColor(0xE6, 0x9F, 0x00)];

/// The plot as an SVG, and in pixels. `refined` has the horizontal axis's name and its values: at least two, each
/// greater than the one before. The left axis has up to three curves, the right one up to two. A curve whose name has a
/// method's in words has that method's colour.
///
/// # Errors
/// If the plotting library fails.
pub fn convergence(
    caption: &str,
    refined: (&str, &[f64]),
    left: &Curves,
    right: &Curves,
) -> Result<[Plot; 2]> {
    let chart = Chart {
        caption,
        refined,
        left,
        right,
    };
    let (svg, picture) = both(SIZE, &chart)?;
    Ok([Plot::Svg(svg), Plot::Png(picture)])
}

struct Chart<'c> {
    caption: &'c str,
    refined: (&'c str, &'c [f64]),
    left: &'c Curves,
    right: &'c Curves,
}

impl Drawing for Chart<'_> {
    const WHAT: &'static str = "the curves";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let (name, refined) = self.refined;
        let ends = [refined[0], refined[refined.len() - 1]];
        let across = || (ends[0] / 1.15..ends[1] * 1.15).log_scale();
        let mut chart = ChartBuilder::on(area)
            .caption(self.caption, (FAMILY, 24))
            .margin(16)
            .x_label_area_size(48)
            .y_label_area_size(76)
            .right_y_label_area_size(76)
            .build_cartesian_2d(
                across().with_key_points(refined.to_vec()),
                self.left.range().log_scale(),
            )?
            .set_secondary_coord(across(), self.right.range().log_scale());
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .x_desc(name)
            .y_desc(&self.left.of_what)
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .x_label_formatter(&|x| format!("{x:.0}"))
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .draw()?;
        chart
            .configure_secondary_axes()
            .y_desc(&self.right.of_what)
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .y_label_formatter(&|y| format!("{y:.0}"))
            .draw()?;
        let points = |values: &[f64]| -> Vec<_> {
            let places = refined.iter().copied();
            places.zip(values.iter().copied()).collect()
        };
        for ((name, values), color) in self.left.curves.iter().zip(LEFT) {
            let color = palette::of_text(name).unwrap_or(color);
            let points = points(values);
            let line = PathElement::new(points.clone(), color.stroke_width(3));
            chart.draw_series([line])?;
            let marks = points
                .into_iter()
                .map(|point| Circle::new(point, 5, color.filled()));
            chart
                .draw_series(marks)?
                .label(name)
                .legend(move |(x, y)| Circle::new((x + 9, y), 5, color.filled()));
        }
        for ((name, values), color) in self.right.curves.iter().zip(RIGHT) {
            let color = palette::of_text(name).unwrap_or(color);
            let points = points(values);
            let line = PathElement::new(points.clone(), color.stroke_width(2));
            chart.draw_secondary_series([line])?;
            let marks = points
                .into_iter()
                .map(|point| TriangleMarker::new(point, 7, color.filled()));
            chart
                .draw_secondary_series(marks)?
                .label(name)
                .legend(move |(x, y)| TriangleMarker::new((x + 9, y), 7, color.filled()));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font((FAMILY, 18))
            .draw()?;
        Ok(())
    }
}

impl Curves {
    /// From the power of ten below all values to some way above them: the upper two sevenths are for the legend, which has
    /// no place where no curve may go.
    fn range(&self) -> std::ops::Range<f64> {
        let values = || self.curves.iter().flat_map(|(_, values)| values).copied();
        let power = |value: f64| value.max(1e-12).log10();
        let low = power(values().fold(f64::INFINITY, f64::min)).floor();
        let high = power(values().fold(0.0, f64::max)).ceil().max(low + 1.0);
        10_f64.powf(low)..10_f64.powf(low + (high - low) * 7.0 / 5.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curves(name: &str, values: &[f64]) -> Curves {
        Curves {
            of_what: name.into(),
            curves: vec![(name.into(), values.to_vec())],
        }
    }

    #[test]
    fn a_curve_has_a_mark_for_each_of_its_values() {
        let error = curves("error", &[0.1, 0.05, 0.025]);
        let cost = curves("cost", &[7.0, 7.0]);
        let [svg, _] = convergence("test", ("slices", &[16.0, 32.0, 64.0]), &error, &cost).unwrap();
        let Plot::Svg(text) = svg else {
            panic!("not an SVG")
        };
        // The legend has one more mark of each curve.
        assert_eq!(text.matches("<circle").count(), 3 + 1, "{text}");
        assert_eq!(text.matches("<polygon").count(), 2 + 1, "{text}");
        for label in ["slices", "error", "cost", "16", "32", "64"] {
            assert!(text.contains(&format!("{label}\n")), "no {label}: {text}");
        }
    }

    #[test]
    fn no_curve_comes_under_the_legend() {
        for values in [&[1.0, 10.0, 999.0][..], &[0.5], &[1e-13, 1e5]] {
            let range = curves("any", values).range();
            let top = values.iter().fold(0.0, |a: f64, b| a.max(*b));
            let part = (top / range.start).log10() / (range.end / range.start).log10();
            assert!(part <= 5.0 / 7.0 + 1e-9, "{values:?} {range:?}");
        }
    }
}
