//! Measures that are shown as colours, with the bar that says which colour is which value.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Drawn, INK, draw_line, line_height, style, width_of};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::image::{Comparison, Image};

/// A measure of each pixel, from 0 up.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    width: u32,
    height: u32,
    values: Vec<f64>,
    most: f64,
    /// The greatest value, which is more than the scale's end if that was set.
    greatest: f64,
    /// Whether there is nothing between two whole numbers.
    whole: bool,
    ramp: Ramp,
}

/// The colours of a measure. Both can be told apart in every kind of colour blindness, because lightness only rises or
/// only falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ramp {
    /// Viridis: 0 is dark violet, the end is yellow.
    Viridis,
    /// 0 is white, the end is black.
    Inverted,
}

impl Measure {
    /// Values row by row from the top, at least 0. The scale ends at the greatest.
    ///
    /// # Panics
    /// If there are not `width x height` values.
    pub fn new(width: u32, height: u32, values: Vec<f64>) -> Self {
        assert_eq!(
            values.len(),
            width as usize * height as usize,
            "a value for each pixel"
        );
        let greatest = values.iter().copied().fold(0.0, f64::max);
        Self {
            width,
            height,
            values,
            most: if greatest > 0.0 && greatest.is_finite() {
                greatest
            } else {
                1.0
            },
            greatest,
            whole: false,
            ramp: Ramp::Viridis,
        }
    }

    /// Counts row by row from the top, as [`Measure::new`].
    ///
    /// # Panics
    /// If there are not `width x height` counts.
    pub fn of_counts(width: u32, height: u32, counts: &[u32]) -> Self {
        let values = counts.iter().copied().map(f64::from).collect();
        Self {
            whole: true,
            ..Self::new(width, height, values)
        }
    }

    /// The largest difference of a channel at each pixel, 0 to 1.
    ///
    /// # Errors
    /// If the pictures' sizes differ.
    pub fn difference(a: &Image, b: &Image) -> Result<Self> {
        Ok(Self::new(a.width, a.height, Comparison::pixels(a, b)?))
    }

    /// The scale ends at `most`, which is more than 0. Greater values have the colour of its end.
    #[must_use]
    pub fn up_to(self, most: f64) -> Self {
        Self { most, ..self }
    }

    /// From white to black, as papers print it.
    #[must_use]
    pub fn inverted(self) -> Self {
        Self {
            ramp: Ramp::Inverted,
            ..self
        }
    }

    /// The colours.
    pub fn image(&self) -> Image {
        Image {
            width: self.width,
            height: self.height,
            pixels: self.values.iter().map(|&value| self.color(value)).collect(),
        }
    }

    fn color(&self, value: f64) -> Rgba {
        // NaN becomes the end, because it is no small value.
        let part = (value / self.most).min(1.0) as f32;
        match self.ramp {
            Ramp::Inverted => Rgba::opaque([1.0 - part; 3]),
            Ramp::Viridis => {
                let RGBColor(r, g, b) = ViridisRGB.get_color(part);
                Rgba::opaque([r, g, b].map(|byte| f32::from(byte) / 255.0))
            }
        }
    }

    /// Draws the bar: colours from 0 to the scale's end, and below it ticks with their values.
    pub(super) fn draw_bar<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        (left, top, width): (i32, i32, i32),
        text: u32,
    ) -> Drawn<B> {
        let bottom = top + bar_thickness(text) as i32;
        // Steps of two pixels: an SVG is not to have a shape for each.
        for x in (0..width).step_by(2) {
            let middle = self.color((f64::from(x) + 1.0) / f64::from(width) * self.most);
            let [r, g, b] = [middle.r, middle.g, middle.b].map(|c| (c * 255.0).round() as u8);
            let ends = [(left + x, top), (left + (x + 2).min(width), bottom)];
            area.draw(&Rectangle::new(ends, RGBColor(r, g, b).filled()))?;
        }
        area.draw(&Rectangle::new(
            [(left, top), (left + width, bottom)],
            INK.stroke_width(1),
        ))?;
        // From the end on, and only where there is room: the last text may be long.
        let mut room = left + width;
        let mut shown = Vec::new();
        for value in self.ticks().into_iter().rev() {
            let label = self.label(value);
            let takes = width_of(&label, text) as i32;
            let x = left + (value / self.most * f64::from(width)).round() as i32;
            // The outer texts stay within the bar's width.
            let start = (x - takes / 2).clamp(left, (left + width - takes).max(left));
            if start + takes <= room {
                room = start - text as i32 / 2;
                shown.push((label, x, start));
            }
        }
        for (label, x, start) in shown.iter().rev() {
            area.draw(&PathElement::new([(*x, bottom), (*x, bottom + 5)], INK))?;
            let at = (*start, bottom + 5);
            draw_line(area, label, &style(text, HPos::Left), at)?;
        }
        Ok(())
    }

    /// 0, and multiples of 1, 2 or 5 times a power of ten: at most six, the last of them at most the scale's end. If the
    /// scale ends early, its end is the last.
    fn ticks(&self) -> Vec<f64> {
        let power = 10_f64.powf((self.most / 5.0).log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .map(|times| times * power)
            .into_iter()
            .find(|step| self.most / step <= 5.0 + 1e-9)
            .unwrap_or(10.0 * power);
        let step = if self.whole { step.max(1.0) } else { step };
        let last = (self.most / step + 1e-9).floor() as u32;
        let mut ticks: Vec<f64> = (0..=last).map(|n| f64::from(n) * step).collect();
        if self.is_cut() {
            ticks.retain(|tick| *tick < self.most);
            ticks.push(self.most);
        }
        ticks
    }

    fn label(&self, value: f64) -> String {
        let number = short(value);
        match value == self.most && self.is_cut() {
            true => format!("{number} and more"),
            false => number,
        }
    }

    fn is_cut(&self) -> bool {
        self.greatest > self.most
    }
}

/// Without zeros that say nothing.
fn short(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        value if value < 1e-3 => format!("{value:.1e}").replace(".0e", "e"),
        value => {
            let places = (2.0 - value.log10().floor()).clamp(0.0, 6.0) as usize;
            let text = format!("{value:.places$}");
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
    }
}

fn bar_thickness(text: u32) -> u32 {
    text * 4 / 5
}

/// The height of the bar with the texts below it.
pub(super) fn bar_height(text: u32) -> u32 {
    bar_thickness(text) + 7 + line_height(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measure(values: &[f64]) -> Measure {
        Measure::new(values.len() as u32, 1, values.to_vec())
    }

    #[test]
    fn a_greater_value_is_lighter_or_inverted_darker() {
        let lightness = |Rgba { r, g, b, .. }: &Rgba| 0.2126 * r + 0.7152 * g + 0.0722 * b;
        let values: Vec<f64> = (0..=20).map(f64::from).collect();
        let rising = measure(&values).image();
        let falling = measure(&values).inverted().image();
        assert!(rising.pixels.is_sorted_by_key(lightness));
        assert!(falling.pixels.iter().rev().is_sorted_by_key(lightness));
        assert_eq!(falling.pixel(0, 0), Rgba::opaque([1.0; 3]));
        assert_eq!(falling.pixel(20, 0), Rgba::opaque([0.0; 3]));
    }

    #[test]
    fn ticks_are_round_and_lie_on_the_scale() {
        assert_eq!(
            measure(&[0.0, 0.43]).ticks(),
            [0.0, 0.1, 0.2, 0.30000000000000004, 0.4]
        );
        assert_eq!(measure(&[0.0, 64.0]).ticks(), [0.0, 20.0, 40.0, 60.0]);
        let counts = Measure::of_counts(2, 1, &[0, 3]);
        assert_eq!(counts.ticks(), [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(Measure::of_counts(2, 1, &[0, 0]).ticks(), [0.0, 1.0]);
        // Values beyond the scale's end are told.
        let cut = measure(&[0.0, 0.5]).up_to(0.125);
        assert_eq!(cut.label(*cut.ticks().last().unwrap()), "0.125 and more");
        assert_eq!(cut.image().pixel(1, 0), cut.color(0.125));
        let not_cut = measure(&[0.0, 0.1]).up_to(0.125);
        assert_eq!(not_cut.label(*not_cut.ticks().last().unwrap()), "0.1");
    }

    #[test]
    fn a_difference_that_is_not_a_number_has_the_colour_of_the_end() {
        let image = |value: f32| Image::filled(1, 1, Rgba::opaque([value; 3]));
        let measure = Measure::difference(&image(f32::NAN), &image(0.0)).unwrap();
        assert_eq!(measure.image().pixel(0, 0), measure.color(1.0));
    }

    #[test]
    fn numbers_are_short() {
        let all = [
            0.0,
            0.30000000000000004,
            0.125,
            20.0,
            100.0,
            1e-5,
            1.5e-4,
            1000.0,
        ];
        assert_eq!(
            all.map(short),
            ["0", "0.3", "0.125", "20", "100", "1e-5", "1.5e-4", "1000"]
        );
    }
}
