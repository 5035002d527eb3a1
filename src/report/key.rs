//! The key of a picture: what each colour stands for.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{Drawn, INK, draw_line, line_height, style, width_of};
use crate::fragment::Rgba;

/// Colours with their texts, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Key(Vec<(Rgba, String)>);

/// A colour's sample and text at their place in a line, in pixels from its left end.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Entry {
    left: u32,
    color: Rgba,
    text: String,
}

impl Key {
    pub(super) fn push(&mut self, color: Rgba, text: &str) {
        self.0.push((color, text.into()));
    }

    /// The key in lines that are at most `width` wide. A text that is wider has a line of its own.
    pub(super) fn lines(&self, text_size: u32, width: u32) -> Vec<Vec<Entry>> {
        let mut lines: Vec<Vec<Entry>> = Vec::new();
        let mut left = 0;
        for (color, text) in &self.0 {
            let takes = sample_width(text_size) + width_of(text, text_size) * 11 / 10;
            if lines.is_empty() || left > 0 && left + takes > width {
                lines.push(Vec::new());
                left = 0;
            }
            if let Some(line) = lines.last_mut() {
                line.push(Entry {
                    left,
                    color: *color,
                    text: text.clone(),
                });
            }
            left += takes + text_size * 5 / 4;
        }
        lines
    }
}

/// The height of so many lines.
pub(super) fn key_height(lines: usize, text_size: u32) -> u32 {
    lines as u32 * line_height(text_size)
}

fn sample_width(text_size: u32) -> u32 {
    text_size * 3 / 2
}

/// Draws the lines from this point on.
pub(super) fn draw_key<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    lines: &[Vec<Entry>],
    (x, y): (i32, i32),
    text_size: u32,
) -> Drawn<B> {
    let size = text_size as i32;
    for (number, line) in (0..).zip(lines) {
        let top = y + number * line_height(text_size) as i32;
        for entry in line {
            let left = x + entry.left as i32;
            let corners = [(left, top + size / 6), (left + size, top + size * 13 / 12)];
            area.draw(&Rectangle::new(corners, rgb(entry.color).filled()))?;
            area.draw(&Rectangle::new(corners, INK.mix(0.5).stroke_width(1)))?;
            let at = (left + sample_width(text_size) as i32, top);
            draw_line(area, &entry.text, &style(text_size, HPos::Left), at)?;
        }
    }
    Ok(())
}

/// The plotting library's colour.
pub(super) fn rgb(color: Rgba) -> RGBColor {
    let [r, g, b] = [color.r, color.g, color.b].map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
    RGBColor(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_broken_into_lines_without_overlaps() {
        let mut key = Key::default();
        let texts = [
            "passes",
            "fails the stencil test",
            "fails the depth test",
            "is clipped",
        ];
        for text in texts {
            key.push(Rgba::opaque([0.5; 3]), text);
        }
        let lines = key.lines(20, 300);
        assert!(lines.len() > 1 && lines.len() < 5);
        assert_eq!(lines.concat().len(), 4);
        for line in &lines {
            for pair in line.windows(2) {
                let end = pair[0].left + sample_width(20) + width_of(&pair[0].text, 20);
                assert!(end < pair[1].left, "{pair:?}");
            }
        }
        assert_eq!(key.lines(20, 10_000).len(), 1);
        assert!(Key::default().lines(20, 300).is_empty());
    }
}
