//! Figure 4 of Everitt 2001: a cross section of the view volume, peeled layer by layer.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{
    Drawing, Drawn, INK, both, draw_line, draw_lines, line_height, style, wrapped,
};
use super::histogram::{Plot, save_either};
use crate::error::Result;

/// A row of pixels, drawn once for each layer: the layer bold, what is behind it thin, what was peeled away light grey.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    title: String,
    layers: usize,
    rows: Vec<Vec<f32>>,
    /// The depths at the ends of the axis, which has all fragments in it.
    ends: [f32; 2],
}

/// The parts of the figure to which a fragment belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    PeeledAway,
    Layer,
    Hidden,
}

/// The part of the axis within which the fragments of neighbouring pixels are joined to a line.
const CLOSE: f32 = 0.06;
const TEXT: u32 = 22;
const MARGIN: i32 = 22;
const WIDTH: i32 = 360;
const HEIGHT: i32 = 420;

impl CrossSection {
    /// `pixels` has the depths of each pixel's fragments, 0 to 1, from the row's one end to the other. Of equal depths one
    /// is drawn. There are `layers` frames, at least 1.
    pub fn new(title: &str, layers: usize, pixels: &[Vec<f32>]) -> Self {
        let sorted = |pixel: &Vec<f32>| {
            let mut depths = pixel.clone();
            depths.sort_by(f32::total_cmp);
            depths.dedup();
            depths
        };
        let rows: Vec<Vec<f32>> = pixels.iter().map(sorted).collect();
        let all = || rows.iter().flatten().copied();
        let (near, far) = (all().fold(1.0, f32::min), all().fold(0.0, f32::max));
        let space = (far - near).max(1e-6) * 0.06;
        Self {
            title: title.into(),
            layers: layers.max(1),
            rows,
            ends: [(near - space).max(0.0), (far + space).min(1.0)],
        }
    }

    /// The figure as an SVG, and in pixels.
    ///
    /// # Errors
    /// If the plotting library fails.
    pub fn draw(&self) -> Result<[Plot; 2]> {
        let (width, title) = (self.width(), self.title_lines());
        let height = self.frames_top(&title) + HEIGHT + 4 * line_height(TEXT) as i32;
        let (svg, picture) = both((width as u32, height as u32), &Sheet(self, title))?;
        Ok([Plot::Svg(svg), Plot::Png(picture)])
    }

    /// Writes the figure as an SVG or a PNG, as the file's name says.
    ///
    /// # Errors
    /// If the name has neither ending, or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        save_either(path.as_ref(), || self.draw())
    }

    fn width(&self) -> i32 {
        self.layers as i32 * (WIDTH + MARGIN) + MARGIN
    }

    fn title_lines(&self) -> Vec<String> {
        wrapped(
            &self.title,
            TEXT * 5 / 4,
            (self.width() - 2 * MARGIN) as u32,
        )
    }

    fn frames_top(&self, title: &[String]) -> i32 {
        MARGIN + (title.len() as u32 * line_height(TEXT * 5 / 4)) as i32 + MARGIN / 2
    }

    /// The fragment of the next pixel that continues the surface of this one: each is the other's nearest. `None` if even
    /// that is far away, so that the surface ends here.
    fn next(&self, pixel: usize, depth: f32) -> Option<f32> {
        let nearest = |pixel: usize, to: f32| {
            let depths = self.rows.get(pixel)?.iter().copied();
            depths.min_by(|a, b| (a - to).abs().total_cmp(&(b - to).abs()))
        };
        let next = nearest(pixel + 1, depth)?;
        let is_close = (next - depth).abs() < (self.ends[1] - self.ends[0]) * CLOSE;
        (is_close && nearest(pixel, next) == Some(depth)).then_some(next)
    }

    /// The two sides of a surface that begins or ends at a pixel, with the farther one's part.
    fn turns(&self, layer: usize) -> impl Iterator<Item = (usize, [f32; 2], Part)> {
        let parts: Vec<_> = self.parts(layer).collect();
        let begins = |pixel: usize, depth: f32| {
            let before = pixel
                .checked_sub(1)
                .map(|before| (before, &self.rows[before]));
            before.is_none_or(|(before, depths)| {
                !depths
                    .iter()
                    .any(|&other| self.next(before, other) == Some(depth))
            })
        };
        let ends = |pixel: usize, depth: f32| self.next(pixel, depth).is_none();
        let turns = parts.windows(2).filter_map(|pair| {
            let [(pixel, nearer, _), (other, farther, part)] = [pair[0], pair[1]];
            let close = farther - nearer < 2.0 * CLOSE * (self.ends[1] - self.ends[0]);
            let both =
                |test: &dyn Fn(usize, f32) -> bool| test(pixel, nearer) && test(pixel, farther);
            let turns = pixel == other && close;
            let below = turns && both(&ends);
            (below || turns && both(&begins)).then_some((
                pixel + usize::from(below),
                [nearer, farther],
                part,
            ))
        });
        turns.collect::<Vec<_>>().into_iter()
    }

    /// What each fragment of the row is in the frame of a layer: the pixel, the depth, the part.
    fn parts(&self, layer: usize) -> impl Iterator<Item = (usize, f32, Part)> {
        let pixels = self.rows.iter().enumerate();
        pixels.flat_map(move |(pixel, depths)| {
            let depths = depths.iter().enumerate();
            depths.map(move |(number, &depth)| {
                let part = match number.cmp(&layer) {
                    std::cmp::Ordering::Less => Part::PeeledAway,
                    std::cmp::Ordering::Equal => Part::Layer,
                    std::cmp::Ordering::Greater => Part::Hidden,
                };
                (pixel, depth, part)
            })
        })
    }
}

struct Sheet<'c>(&'c CrossSection, Vec<String>);

impl Drawing for Sheet<'_> {
    const WHAT: &'static str = "the cross section";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let Self(section, title) = self;
        draw_lines(area, title, TEXT * 5 / 4, (MARGIN, MARGIN, HPos::Left))?;
        let top = section.frames_top(title);
        let [near, far] = section.ends;
        let centred = style(TEXT, HPos::Center);
        let line = line_height(TEXT) as i32;
        for layer in 0..section.layers {
            let left = MARGIN + layer as i32 * (WIDTH + MARGIN);
            let pixel_height = f64::from(HEIGHT) / section.rows.len().max(1) as f64;
            for wanted in [Part::PeeledAway, Part::Hidden, Part::Layer] {
                let (color, width) = match wanted {
                    Part::PeeledAway => (RGBColor(0xC8, 0xC8, 0xC8), 2),
                    Part::Hidden => (INK, 1),
                    Part::Layer => (BLACK, 5),
                };
                let x = |depth: f32| {
                    left + ((depth - near) / (far - near) * WIDTH as f32).round() as i32
                };
                let y = |pixel: usize| top + (pixel as f64 * pixel_height).round() as i32;
                for (pixel, depth, _) in section.parts(layer).filter(|(.., part)| *part == wanted) {
                    // At least as high as its pixel, and on to where its surface goes.
                    let next = section.next(pixel, depth).unwrap_or(depth);
                    let ends = [(x(depth), y(pixel)), (x(next), y(pixel + 1))];
                    area.draw(&PathElement::new(ends, color.stroke_width(width)))?;
                }
                // Where a surface turns, its two sides end in the same pixel. The turn belongs to the farther one.
                for (pixel, [nearer, farther], _) in
                    section.turns(layer).filter(|(.., part)| *part == wanted)
                {
                    let ends = [(x(nearer), y(pixel)), (x(farther), y(pixel))];
                    area.draw(&PathElement::new(ends, color.stroke_width(width)))?;
                }
            }
            let corners = [(left, top), (left + WIDTH, top + HEIGHT)];
            area.draw(&Rectangle::new(corners, INK.mix(0.5).stroke_width(1)))?;
            let samples = section
                .parts(layer)
                .filter(|(.., part)| *part == Part::Layer);
            let caption = format!("layer {layer}: {} samples", samples.count());
            let below = top + HEIGHT + line / 4;
            draw_line(
                area,
                &format!("{near:.2}"),
                &style(TEXT, HPos::Left),
                (left, below),
            )?;
            draw_line(area, "depth", &centred, (left + WIDTH / 2, below))?;
            let end = (left + WIDTH, below);
            draw_line(area, &format!("{far:.2}"), &style(TEXT, HPos::Right), end)?;
            draw_line(area, &caption, &centred, (left + WIDTH / 2, below + line))?;
        }
        let key = "bold: the layer, thin: hidden behind it, grey: peeled away";
        let at = (MARGIN, top + HEIGHT + line * 5 / 2);
        draw_line(area, key, &style(TEXT, HPos::Left), at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_frame_has_every_fragment_once_and_the_layer_bold() {
        let pixels = [vec![0.5, 0.2, 0.9], vec![], vec![0.4, 0.4, 0.3]];
        let section = CrossSection::new("title", 3, &pixels);
        for (layer, bold) in [(0, vec![0.2, 0.3]), (1, vec![0.5, 0.4]), (2, vec![0.9])] {
            let parts: Vec<_> = section.parts(layer).collect();
            assert_eq!(parts.len(), 3 + 2);
            let found = parts.iter().filter(|(.., part)| *part == Part::Layer);
            assert_eq!(found.map(|(_, depth, _)| *depth).collect::<Vec<_>>(), bold);
        }
        let peeled = section
            .parts(1)
            .filter(|(.., part)| *part == Part::PeeledAway);
        assert_eq!(peeled.count(), 2);
        let [Plot::Svg(text), _] = section.draw().unwrap() else {
            panic!("not an SVG")
        };
        for expected in [
            "title\n",
            "layer 0: 2 samples\n",
            "layer 2: 1 samples\n",
            "depth\n",
        ] {
            assert!(text.contains(expected), "no {expected}: {text}");
        }
        // The bold lines, of all three frames.
        assert_eq!(text.matches(r#"stroke-width="5""#).count(), 5, "{text}");
    }

    #[test]
    fn a_row_without_fragments_can_be_drawn() {
        CrossSection::new("nothing", 1, &[vec![], vec![]])
            .draw()
            .unwrap();
        CrossSection::new("no pixel", 1, &[]).draw().unwrap();
    }
}
