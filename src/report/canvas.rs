//! The parts that all plots share: one font, lines of text, and both kinds of file from one drawing.

use std::sync::Once;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

use crate::error::{Error, Result};
use crate::fragment::Rgba;
use crate::image::Image;

pub(super) const FAMILY: &str = "sans-serif";
/// The colour of text and of frames: dark enough to be read at half its size.
pub(super) const INK: RGBColor = RGBColor(0x20, 0x20, 0x20);

/// What a drawing's commands answer.
pub(super) type Drawn<B> = std::result::Result<
    (),
    DrawingAreaErrorKind<<B as plotters::backend::DrawingBackend>::ErrorType>,
>;

/// Something that is drawn in the same way as an SVG and in pixels.
pub(super) trait Drawing {
    /// The noun for errors, as "the histogram".
    const WHAT: &'static str;

    /// Draws on an area of the size that [`both`] was given.
    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B>;
}

/// A drawing as an SVG's text, and in pixels. What it leaves free is white.
pub(super) fn both<D: Drawing>(size: (u32, u32), drawing: &D) -> Result<(String, Image)> {
    register_the_font();
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
    on_white(&area, drawing)?;
    drop(area);
    let mut bytes = vec![0; size.0 as usize * size.1 as usize * 3];
    let area = BitMapBackend::with_buffer(&mut bytes, size).into_drawing_area();
    on_white(&area, drawing)?;
    drop(area);
    Ok((text, in_pixels(size, &bytes)))
}

fn on_white<D: Drawing, B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    drawing: &D,
) -> Result<()> {
    let all = || {
        area.fill(&WHITE)?;
        drawing.draw(area)?;
        area.present()
    };
    all().map_err(|error: DrawingAreaErrorKind<B::ErrorType>| Error::Plot {
        what: D::WHAT,
        answer: error.to_string(),
    })
}

/// The picture in a plotting library's bytes, three per pixel.
fn in_pixels((width, height): (u32, u32), bytes: &[u8]) -> Image {
    let pixel = |rgb: &[u8]| Rgba::opaque([0, 1, 2].map(|n| f32::from(rgb[n]) / 255.0));
    Image {
        width,
        height,
        pixels: bytes.chunks_exact(3).map(pixel).collect(),
    }
}

/// Makes [`FAMILY`] known to the plotting library.
fn register_the_font() {
    static FONT: Once = Once::new();
    FONT.call_once(|| {
        // The font is bundled, so that a plot is the same on every machine. It can be read, so the answer is Ok.
        let _ = register_font(
            FAMILY,
            FontStyle::Normal,
            epaint_default_fonts::UBUNTU_LIGHT,
        );
    });
}

/// The style of a text that [`draw_line`] draws to the right of its point, around it, or to the left of it.
pub(super) fn style(size: u32, across: HPos) -> TextStyle<'static> {
    TextStyle::from((FAMILY, size).into_font())
        .color(&INK)
        .pos(Pos::new(across, VPos::Top))
}

/// The distance between the tops of two lines of a text.
pub(super) fn line_height(size: u32) -> u32 {
    size * 5 / 4
}

/// A text's width in the bundled font, in pixels.
pub(super) fn width_of(text: &str, size: u32) -> u32 {
    register_the_font();
    let style = style(size, HPos::Left);
    let extent = style.font.layout_box(text);
    extent.map_or(0, |((left, _), (right, _))| (right - left).max(0) as u32)
}

/// A text in lines that are at most `width` wide. A word that is wider has a line of its own. An SVG is shown in a font
/// of the reader's machine, which may be wider than the bundled one by a tenth, so lines are a tenth shorter.
pub(super) fn wrapped(text: &str, size: u32, width: u32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        if let Some(line) = lines.last_mut()
            && width_of(&format!("{line} {word}"), size) * 10 <= width * 9
        {
            *line += " ";
            *line += word;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// Draws lines of text below each other, from this point on.
pub(super) fn draw_lines<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    lines: &[String],
    size: u32,
    (x, y, across): (i32, i32, HPos),
) -> Drawn<B> {
    for (number, line) in (0..).zip(lines) {
        let top = y + number * line_height(size) as i32;
        draw_line(area, line, &style(size, across), (x, top))?;
    }
    Ok(())
}

/// Draws a line of text below this point, in the middle of the line's height.
pub(super) fn draw_line<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    text: &str,
    style: &TextStyle<'_>,
    (x, y): (i32, i32),
) -> Drawn<B> {
    // The plotting library has the line on which letters stand half the text's size below the point, and in an SVG a
    // little more.
    let down = style.font.get_size() * 0.4;
    area.draw_text(text, style, (x, y + down.round() as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_no_wider_than_asked_and_lose_no_word() {
        let text = "the layers that are nearest at each of the image's pixels, one by one";
        let lines = wrapped(text, 20, 160);
        assert!(lines.len() > 3, "{lines:?}");
        assert!(
            lines.iter().all(|line| width_of(line, 20) <= 160),
            "{lines:?}"
        );
        assert_eq!(lines.join(" "), text);
        // A word that is too wide for any line is not cut, and what is wide enough is not wrapped.
        assert_eq!(wrapped("incomprehensibilities", 20, 40).len(), 1);
        assert_eq!(wrapped(text, 20, 4000).len(), 1);
    }
}
