//! A plot of what methods cost: a line for each of them, between logarithmic axes.

use plotters::coord::Shift;
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Drawing, Drawn, FAMILY, both, draw_line, line_height, style};
use super::{Plot, palette};
use crate::error::{Error, Result};

/// What one method costs.
#[derive(Clone, Debug, PartialEq)]
pub struct CostLine {
    /// The method's name, or `VTK` and a mode's.
    pub name: String,
    /// Places on both axes, all greater than 0, in order along the horizontal one.
    pub points: Vec<[f64; 2]>,
    /// Whether the points are joined. Those of scenes that have nothing to do with each other are not.
    pub joined: bool,
}

const SIZE: (u32, u32) = (1200, 680);
/// The width of the part that has the legend.
const LEGEND: u32 = 250;
const LINE: i32 = 28;
const TEXT: u32 = 18;

/// The plot as an SVG, and in pixels. The legend stands beside the axes, in the order in which the lines end, from the top.
/// Each method has the colour that it has in every plot; lines of VTK are broken.
///
/// # Errors
/// If the plotting library fails, or no line has a point.
pub fn costs(caption: &str, across: &str, up: &str, lines: &[CostLine]) -> Result<[Plot; 2]> {
    let lines = from_the_top(lines);
    let (Some(xs), Some(ys)) = (range(&lines, 0), range(&lines, 1)) else {
        return Err(Error::Plot {
            what: Chart::WHAT,
            answer: "no method has a cost".into(),
        });
    };
    let chart = Chart {
        caption,
        across,
        up,
        lines: &lines,
        ranges: [xs, ys],
    };
    let (svg, picture) = both(SIZE, &chart)?;
    Ok([Plot::Svg(svg), Plot::Png(picture)])
}

/// The lines that have points, the one that ends highest first.
fn from_the_top(lines: &[CostLine]) -> Vec<CostLine> {
    let end = |line: &CostLine| line.points.last().map_or(0.0, |&[_, y]| y);
    let mut lines: Vec<_> = lines
        .iter()
        .filter(|line| !line.points.is_empty())
        .cloned()
        .collect();
    lines.sort_by(|a, b| end(b).total_cmp(&end(a)));
    lines
}

struct Chart<'c> {
    caption: &'c str,
    across: &'c str,
    up: &'c str,
    lines: &'c [CostLine],
    /// The ends of both axes.
    ranges: [[f64; 2]; 2],
}

impl Drawing for Chart<'_> {
    const WHAT: &'static str = "the costs";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let [xs, ys] = self.ranges;
        let (left, legend) = area.split_horizontally(SIZE.0 - LEGEND);
        let mut chart = ChartBuilder::on(&left)
            .caption(self.caption, (FAMILY, 24))
            .margin(16)
            .x_label_area_size(56)
            .y_label_area_size(84)
            .build_cartesian_2d(
                (xs[0] / 1.1..xs[1] * 1.1)
                    .log_scale()
                    .with_key_points(ticks(xs)),
                (ys[0] / 1.3..ys[1] * 1.3)
                    .log_scale()
                    .with_key_points(ticks(ys)),
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_desc(self.across)
            .y_desc(self.up)
            .axis_desc_style((FAMILY, 22))
            .label_style((FAMILY, 18))
            .x_label_formatter(&|x| number(*x))
            .y_label_formatter(&|y| number(*y))
            .draw()?;
        for (place, line) in self.lines.iter().enumerate() {
            let color = palette::of_method(&line.name);
            let points = || line.points.iter().map(|&[x, y]| (x, y));
            let y = 60 + LINE * place as i32;
            let sample = match is_vtk(line) {
                true => [[(0, y), (6, y)], [(20, y), (26, y)]],
                false => [[(0, y), (26, y)]; 2],
            };
            if line.joined {
                if is_vtk(line) {
                    let style = color.stroke_width(2);
                    chart.draw_series([DashedPathElement::new(points(), 8, 5, style)])?;
                } else {
                    let path: Vec<_> = points().collect();
                    chart.draw_series([PathElement::new(path, color.stroke_width(3))])?;
                }
                for part in sample {
                    legend.draw(&PathElement::new(part, color.stroke_width(3)))?;
                }
            }
            let filled = color.filled();
            match Mark::of(&line.name) {
                Mark::Circle => {
                    chart.draw_series(points().map(|point| Circle::new(point, 5, filled)))?;
                    legend.draw(&Circle::new((13, y), 5, filled))?;
                }
                Mark::Triangle => {
                    let triangle = |point| TriangleMarker::new(point, 6, filled);
                    chart.draw_series(points().map(triangle))?;
                    legend.draw(&TriangleMarker::new((13, y), 6, filled))?;
                }
                Mark::Cross => {
                    let cross = |point| Cross::new(point, 5, color.stroke_width(2));
                    chart.draw_series(points().map(cross))?;
                    legend.draw(&Cross::new((13, y), 5, color.stroke_width(2)))?;
                }
            }
            let at = (36, y - line_height(TEXT) as i32 / 2);
            draw_line(&legend, &line.name, &style(TEXT, HPos::Left), at)?;
        }
        Ok(())
    }
}

/// The smallest and the largest place on an axis. `None` if there is none.
fn range(lines: &[CostLine], axis: usize) -> Option<[f64; 2]> {
    let points = lines.iter().flat_map(|line| &line.points);
    let places = points.map(|point| point[axis].max(1e-9));
    places.fold(None, |range, place| match range {
        None => Some([place, place]),
        Some([low, high]) => Some([low.min(place), high.max(place)]),
    })
}

/// Colour is not to be the only sign of what kind of method a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mark {
    /// Peels, or draws what is sorted.
    Circle,
    /// Fills lists.
    Triangle,
    /// Blends without an order.
    Cross,
}

impl Mark {
    fn of(name: &str) -> Self {
        let begins = |with: &[&str]| with.iter().any(|start| name.starts_with(start));
        match () {
            () if begins(&["ffb", "dfb", "ppll"]) => Self::Triangle,
            () if begins(&["blend", "weighted", "multi-layer", "VTK alpha"]) => Self::Cross,
            () => Self::Circle,
        }
    }
}

fn is_vtk(line: &CostLine) -> bool {
    line.name.starts_with("VTK")
}

/// Powers of two within a range of less than two powers of ten, otherwise 1, 2 and 5 times powers of ten.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let all: Vec<f64> = match high / low < 200.0 {
        true => (-20..=40).map(|power| 2_f64.powi(power)).collect(),
        false => {
            let powers = (-6..=9).map(|power| 10_f64.powi(power));
            powers
                .flat_map(|power| [power, 2.0 * power, 5.0 * power])
                .collect()
        }
    };
    // No further than the axes go: a line beyond them would cross the legend.
    let within = low / 1.1..=high * 1.1;
    all.into_iter()
        .filter(|tick| within.contains(tick))
        .collect()
}

/// Without zeros that say nothing.
fn number(value: f64) -> String {
    match value {
        value if value >= 1.0 => format!("{value:.0}"),
        value => {
            let places = (1.0 - value.log10().floor()) as usize;
            format!("{value:.places$}").trim_end_matches('0').to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &str, points: &[[f64; 2]]) -> CostLine {
        CostLine {
            name: name.into(),
            points: points.to_vec(),
            joined: true,
        }
    }

    #[test]
    fn every_line_has_its_colour_its_marks_and_its_name_in_the_legend() {
        let lines = [
            line("blend", &[[1.0, 1.0], [2.0, 2.0], [4.0, 4.0]]),
            line("dfb", &[[1.0, 3.0], [2.0, 6.0]]),
            line("VTK dual", &[[4.0, 90.0]]),
            line("painter", &[]),
        ];
        let [Plot::Svg(text), Plot::Png(_)] = costs("title", "layers", "ms", &lines).unwrap()
        else {
            panic!("an SVG and a picture were promised");
        };
        // The legend has one more mark of each line: circles for VTK's peeling, triangles for lists, crosses of two strokes
        // for blending.
        assert_eq!(text.matches("<circle").count(), 1 + 1, "{text}");
        assert_eq!(text.matches("<polygon").count(), 2 + 1, "{text}");
        let black = r##"stroke="#000000""##;
        assert!(text.matches(black).count() >= 2 * (3 + 1), "{text}");
        for label in [
            "title", "layers", "ms", "blend", "dfb", "VTK dual", "1", "2", "4",
        ] {
            assert!(text.contains(&format!("{label}\n")), "no {label}: {text}");
        }
        assert!(!text.contains("painter"), "{text}");
        let place = |name: &str| text.find(&format!("{name}\n")).unwrap();
        assert!(place("VTK dual") < place("dfb") && place("dfb") < place("blend"));
        assert!(costs("nothing", "", "", &lines[3..]).is_err());
    }

    #[test]
    fn ticks_lie_in_the_range_and_say_what_they_are() {
        assert_eq!(ticks([1.0, 8.0]), [1.0, 2.0, 4.0, 8.0]);
        let wide = ticks([0.9, 900.0]);
        assert_eq!(wide, [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0]);
        assert_eq!(
            [0.25, 0.02, 0.5, 1.0, 128.0].map(number),
            ["0.25", "0.02", "0.5", "1", "128"]
        );
    }
}
