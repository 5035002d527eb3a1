//! Figure 6 of Lindholm et al. 2015: bars side by side, a group for each scene.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::Plot;
use super::canvas::{Drawing, Drawn, FAMILY, both, draw_line, style};
use super::palette::A_BUFFERS;

use crate::error::Result;

/// A group of bars.
#[derive(Clone, Debug, PartialEq)]
pub struct BarGroup {
    /// The text under the group.
    pub name: String,
    /// The heights of the bars, at least 0, in the chart's order of names.
    pub heights: Vec<f64>,
}

const SIZE: (u32, u32) = (1280, 560);
/// The chart as an SVG, and in pixels. A line marks the height 1, to which ratios are relative. `of_what` names the
/// vertical axis. There are at most twelve names.
///
/// # Errors
/// If the plotting library fails.
pub fn bars(
    caption: &str,
    of_what: &str,
    names: &[String],
    groups: &[BarGroup],
) -> Result<[Plot; 2]> {
    let chart = Chart {
        caption,
        of_what,
        names,
        groups,
    };
    let (svg, picture) = both(SIZE, &chart)?;
    Ok([Plot::Svg(svg), Plot::Png(picture)])
}

fn colors() -> impl Iterator<Item = RGBColor> {
    A_BUFFERS.into_iter().map(|(_, color)| color)
}

struct Chart<'a> {
    caption: &'a str,
    of_what: &'a str,
    names: &'a [String],
    groups: &'a [BarGroup],
}

impl Drawing for Chart<'_> {
    const WHAT: &'static str = "the bars";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let heights = self.groups.iter().flat_map(|group| &group.heights);
        let top = heights.copied().fold(1.0, f64::max) * 1.1;
        // On either side of a group there is space as wide as a bar.
        let width = 1.0 / (self.names.len() + 2) as f64;
        let end = self.groups.len().max(1) as f64;
        let (left, legend) = area.split_horizontally(SIZE.0 - 200);
        let mut chart = ChartBuilder::on(&left)
            .caption(self.caption, (FAMILY, 24))
            .margin(16)
            .x_label_area_size(40)
            .y_label_area_size(64)
            .build_cartesian_2d(0.0..end, 0.0..top)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .disable_x_axis()
            .light_line_style(TRANSPARENT)
            .y_desc(self.of_what)
            .axis_desc_style((FAMILY, 20))
            .label_style((FAMILY, 18))
            .draw()?;
        for (n, color) in (0..self.names.len()).zip(colors()) {
            let bars = self.groups.iter().enumerate().filter_map(|(place, group)| {
                let x = place as f64 + (n + 1) as f64 * width;
                let ends = [(x, 0.0), (x + 0.9 * width, *group.heights.get(n)?)];
                Some(Rectangle::new(ends, color.filled()))
            });
            chart.draw_series(bars)?;
        }
        chart.draw_series([PathElement::new([(0.0, 1.0), (end, 1.0)], BLACK)])?;
        for (place, group) in self.groups.iter().enumerate() {
            let (x, y) = chart.backend_coord(&(place as f64 + 0.5, 0.0));
            draw_line(&left, &group.name, &style(20, HPos::Center), (x, y + 8))?;
        }
        for (n, (name, color)) in self.names.iter().zip(colors()).enumerate() {
            let y = 70 + 34 * n as i32;
            legend.draw(&Rectangle::new([(0, y), (22, y + 18)], color.filled()))?;
            draw_line(&legend, name, &style(18, HPos::Left), (30, y - 2))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bar_is_drawn_in_its_colour_and_to_its_height() {
        let groups = [BarGroup {
            name: "scene".into(),
            heights: vec![1.0, 2.0],
        }];
        let names = ["one".to_owned(), "two".to_owned()];
        let [Plot::Svg(text), Plot::Png(image)] = bars("", "ratio", &names, &groups).unwrap()
        else {
            panic!("an SVG and a picture were promised");
        };
        assert!(text.contains("scene") && text.contains("two"), "{text}");
        // The legend's swatches lie to the right of the bars.
        let pixels = |color: RGBColor| {
            let is = |channel: f32, byte: u8| (channel * 255.0 - f32::from(byte)).abs() < 0.5;
            let of_it = image.pixels.iter().enumerate().filter(|(place, pixel)| {
                (*place as u32 % SIZE.0) < SIZE.0 - 200
                    && is(pixel.r, color.0)
                    && is(pixel.g, color.1)
                    && is(pixel.b, color.2)
            });
            of_it.count() as f64
        };
        let ratio = pixels(A_BUFFERS[1].1) / pixels(A_BUFFERS[0].1);
        // A bar of more than a hundred pixels may be a pixel higher or lower.
        assert!((ratio - 2.0).abs() < 0.03, "{ratio}");
    }
}
