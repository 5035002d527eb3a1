//! Pictures that stand alone: a title, panels with captions, and what explains their colours.
//!
//! A panel's pixels are those of its picture, enlarged by whole numbers if it is small, and never mixed.

mod layout;

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use self::layout::{Contents, Layout, PanelContents, Place};
use super::canvas::{Drawing, Drawn, INK, both, draw_lines};
use super::histogram::{Plot, save_either};
use super::key::{Key, draw_key};
use super::scale::Measure;
use crate::error::{Error, Result};
use crate::fragment::Rgba;
use crate::image::Image;

/// A sheet of panels in rows, from the left.
#[derive(Clone, Debug, PartialEq)]
pub struct Panels {
    title: String,
    columns: usize,
    panels: Vec<Panel>,
    key: Key,
}

/// A picture and what it shows.
#[derive(Clone, Debug, PartialEq)]
struct Panel {
    image: Image,
    caption: String,
    measure: Option<Measure>,
}

impl Panels {
    /// A sheet without panels. The title says what all of it shows, and where that was published.
    pub fn new(title: &str) -> Self {
        Self {
            title: title.into(),
            columns: usize::MAX,
            panels: Vec::new(),
            key: Key::default(),
        }
    }

    /// So many panels in a row, at least 1. Without this, all are in one row.
    #[must_use]
    pub fn columns(self, columns: usize) -> Self {
        let columns = columns.max(1);
        Self { columns, ..self }
    }

    /// One more panel. The caption says what this picture shows that the others do not.
    #[must_use]
    pub fn picture(mut self, image: &Image, caption: &str) -> Self {
        self.panels.push(Panel {
            image: image.clone(),
            caption: caption.into(),
            measure: None,
        });
        self
    }

    /// One more panel, with a bar that says which colour is which value. The caption names the quantity and its unit.
    #[must_use]
    pub fn measure(mut self, measure: Measure, caption: &str) -> Self {
        self.panels.push(Panel {
            image: measure.image(),
            caption: caption.into(),
            measure: Some(measure),
        });
        self
    }

    /// One more panel: the largest difference of a channel at each pixel.
    ///
    /// # Errors
    /// If the pictures' sizes differ.
    pub fn difference(self, a: &Image, b: &Image, caption: &str) -> Result<Self> {
        Ok(self.measure(Measure::difference(a, b)?, caption))
    }

    /// Explains a colour below the panels.
    #[must_use]
    pub fn key(mut self, color: Rgba, text: &str) -> Self {
        self.key.push(color, text);
        self
    }

    /// The sheet as an SVG, which embeds its pictures, and in pixels.
    ///
    /// # Errors
    /// If the plotting library fails.
    pub fn draw(&self) -> Result<[Plot; 2]> {
        let layout = self.layout();
        let sheet = Sheet {
            panels: self,
            layout: &layout,
        };
        let (mut svg, mut picture) = both(layout.size, &sheet)?;
        let end = svg.rfind("</svg>").unwrap_or(svg.len());
        let mut embedded = String::new();
        for (panel, place) in self.panels.iter().zip(&layout.places) {
            embedded += &element(&panel.image, place)?;
            paste(&panel.image, place, &mut picture);
        }
        svg.insert_str(end, &embedded);
        Ok([Plot::Svg(svg), Plot::Png(picture)])
    }

    fn layout(&self) -> Layout {
        let panel = |panel: &'_ Panel| PanelContents {
            size: [panel.image.width, panel.image.height],
            caption: panel.caption.clone(),
            has_bar: panel.measure.is_some(),
        };
        Layout::of(&Contents {
            title: &self.title,
            columns: self.columns,
            panels: self.panels.iter().map(panel).collect(),
            key: &self.key,
        })
    }

    /// Writes the sheet as an SVG or a PNG, as the file's name says.
    ///
    /// # Errors
    /// If the name has neither ending, or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        save_either(path.as_ref(), || self.draw())
    }
}

/// Everything but the panels' pixels.
struct Sheet<'p> {
    panels: &'p Panels,
    layout: &'p Layout,
}

impl Drawing for Sheet<'_> {
    const WHAT: &'static str = "the panels";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let layout = self.layout;
        let corner = (layout.margin as i32, layout.margin as i32, HPos::Left);
        draw_lines(area, &layout.title, layout.title_text, corner)?;
        for (panel, place) in self.panels.panels.iter().zip(&layout.places) {
            let [left, top, width, height] =
                [place.left, place.top, place.width, place.height].map(|v| v as i32);
            // The frame is around the picture and not on it.
            let frame = [(left - 1, top - 1), (left + width, top + height)];
            area.draw(&Rectangle::new(frame, INK.mix(0.5).stroke_width(1)))?;
            let middle = (left + width / 2, place.caption_top as i32, HPos::Center);
            draw_lines(area, &place.caption, layout.text, middle)?;
            if let Some(measure) = &panel.measure {
                let bar = (left, place.bar_top as i32, width);
                measure.draw_bar(area, bar, layout.text)?;
            }
        }
        let (left, top) = layout.key;
        draw_key(
            area,
            &layout.key_lines,
            (left as i32, top as i32),
            layout.text,
        )
    }
}

/// Puts the pixels at their place.
fn paste(image: &Image, place: &Place, sheet: &mut Image) {
    for y in 0..place.height {
        let row = (place.top + y) * sheet.width + place.left;
        for x in 0..place.width {
            let pixel = image.pixel(x / place.zoom, y / place.zoom);
            sheet.pixels[(row + x) as usize] = over_white(pixel);
        }
    }
}

/// A sheet is opaque, so that text on it can be read anywhere.
fn over_white(pixel: Rgba) -> Rgba {
    let channel = |c: f32| c * pixel.a + (1.0 - pixel.a);
    match pixel.a < 1.0 {
        true => Rgba::opaque([pixel.r, pixel.g, pixel.b].map(channel)),
        false => pixel,
    }
}

/// The SVG's element of a picture, with its own pixels as a PNG.
fn element(image: &Image, place: &Place) -> Result<String> {
    let png = image.to_png().map_err(|answer| Error::Plot {
        what: Sheet::WHAT,
        answer,
    })?;
    let data = STANDARD.encode(png);
    let Place {
        left,
        top,
        width,
        height,
        ..
    } = place;
    Ok(format!(
        "<image x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" style=\"image-rendering:pixelated\" \
         href=\"data:image/png;base64,{data}\"/>\n"
    ))
}

#[cfg(test)]
mod tests;
