//! Rows of labelled boxes: what happened to fragments, how memory is laid out.

use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::canvas::{
    Drawing, Drawn, INK, both, draw_line, draw_lines, line_height, style, width_of, wrapped,
};
use super::histogram::{Plot, save_either};
use super::key::{Key, draw_key, key_height, rgb};
use crate::error::Result;
use crate::fragment::Rgba;

/// A drawing of boxes in rows. Each row has a label at its left, and may have texts at its right.
#[derive(Clone, Debug, PartialEq)]
pub struct Strips {
    pub(super) title: String,
    /// The texts above the boxes, which are as wide as these, and above the texts at the right.
    pub(super) heads: [Vec<String>; 2],
    pub(super) rows: Vec<Strip>,
    /// The width and the height of a box, in pixels.
    pub(super) cell: u32,
    pub(super) key: Key,
}

/// A row. One without boxes and texts is a heading.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Strip {
    pub(super) label: String,
    pub(super) cells: Vec<Cell>,
    pub(super) after: Vec<String>,
}

/// A box.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cell {
    pub(super) color: Rgba,
    pub(super) text: String,
}

const TEXT: u32 = 20;
const TITLE: u32 = 26;
const MARGIN: u32 = 20;
/// The widest label. Longer ones are wrapped.
const LABEL: u32 = 430;
/// Between rows.
const GAP: u32 = 10;

impl Cell {
    pub(super) fn new(color: Rgba, text: impl ToString) -> Self {
        let text = text.to_string();
        Self { color, text }
    }
}

impl Strip {
    pub(super) fn heading(label: &str) -> Self {
        Self {
            label: label.into(),
            ..Self::default()
        }
    }

    fn is_heading(&self) -> bool {
        self.cells.is_empty() && self.after.is_empty()
    }
}

impl Strips {
    /// The drawing as an SVG, and in pixels.
    ///
    /// # Errors
    /// If the plotting library fails.
    pub fn draw(&self) -> Result<[Plot; 2]> {
        let layout = Layout::of(self);
        let (svg, picture) = both(layout.size, &Sheet(self, &layout))?;
        Ok([Plot::Svg(svg), Plot::Png(picture)])
    }

    /// Writes the drawing as an SVG or a PNG, as the file's name says.
    ///
    /// # Errors
    /// If the name has neither ending, or the file cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        save_either(path.as_ref(), || self.draw())
    }
}

/// Where the parts are.
struct Layout {
    size: (u32, u32),
    title: Vec<String>,
    heads_top: u32,
    /// The left end of the boxes.
    cells: u32,
    /// The middle of each column of texts at the right.
    after: Vec<u32>,
    /// Each row's lines of label, top, and height.
    rows: Vec<(Vec<String>, u32, u32)>,
    key_top: u32,
    key: Vec<Vec<super::key::Entry>>,
}

impl Layout {
    fn of(strips: &Strips) -> Self {
        let rows = || strips.rows.iter();
        let labels = rows().filter(|row| !row.is_heading());
        let label = labels.map(|row| width_of(&row.label, TEXT) * 10 / 9 + 2);
        let label = label.max().unwrap_or(0).min(LABEL);
        let cells = MARGIN + label + GAP;
        let most = rows().map(|row| row.cells.len()).max().unwrap_or(0) as u32;
        let mut right = cells + most * strips.cell;
        let mut after = Vec::new();
        for column in 0..rows().map(|row| row.after.len()).max().unwrap_or(0) {
            let texts = rows().filter_map(|row| row.after.get(column));
            let widths = texts.chain(strips.heads[1].get(column));
            let width = widths.map(|text| width_of(text, TEXT)).max();
            let width = width.unwrap_or(0) * 11 / 10 + 2 * GAP;
            after.push(right + GAP + width / 2);
            right += GAP + width;
        }
        let headings = rows().filter(|row| row.is_heading());
        let heading = headings.map(|row| width_of(&row.label, TEXT) * 11 / 10);
        right = right.max(MARGIN + heading.max().unwrap_or(0)).max(600);
        let inner = right - MARGIN;

        let title = wrapped(&strips.title, TITLE, inner);
        let heads_top = MARGIN + title.len() as u32 * line_height(TITLE) + GAP;
        let has_heads = strips.heads.iter().any(|heads| !heads.is_empty());
        let mut top = heads_top + if has_heads { line_height(TEXT) } else { 0 };
        let mut places = Vec::new();
        for row in &strips.rows {
            let lines = match row.is_heading() {
                true => {
                    top += GAP;
                    vec![row.label.clone()]
                }
                false => wrapped(&row.label, TEXT, label),
            };
            let text = lines.len() as u32 * line_height(TEXT);
            let boxes = if row.is_heading() { 0 } else { strips.cell };
            places.push((lines, top, text.max(boxes)));
            top += text.max(boxes) + GAP;
        }
        let key = strips.key.lines(TEXT, inner);
        let key_top = top + GAP;
        Self {
            size: (right + MARGIN, key_top + key_height(key.len(), TEXT) + GAP),
            title,
            heads_top,
            cells,
            after,
            rows: places,
            key_top,
            key,
        }
    }
}

struct Sheet<'s>(&'s Strips, &'s Layout);

impl Drawing for Sheet<'_> {
    const WHAT: &'static str = "the boxes";

    fn draw<B: DrawingBackend>(&self, area: &DrawingArea<B, Shift>) -> Drawn<B> {
        let Self(strips, layout) = self;
        let margin = MARGIN as i32;
        draw_lines(area, &layout.title, TITLE, (margin, margin, HPos::Left))?;
        let cell = strips.cell as i32;
        let middle = |place: usize| layout.cells as i32 + place as i32 * cell + cell / 2;
        let centred = style(TEXT, HPos::Center);
        let [over_cells, over_after] = &strips.heads;
        for (place, head) in over_cells.iter().enumerate() {
            draw_line(
                area,
                head,
                &centred,
                (middle(place), layout.heads_top as i32),
            )?;
        }
        for (x, head) in layout.after.iter().zip(over_after) {
            draw_line(area, head, &centred, (*x as i32, layout.heads_top as i32))?;
        }
        for (row, (label, top, height)) in strips.rows.iter().zip(&layout.rows) {
            let line_top = |lines: usize, of: u32| {
                (top + (height - (lines as u32 * line_height(of)).min(*height)) / 2) as i32
            };
            let at = (margin, line_top(label.len(), TEXT), HPos::Left);
            draw_lines(area, label, TEXT, at)?;
            let top = (top + (height - strips.cell.min(*height)) / 2) as i32;
            for (place, cell_of_row) in row.cells.iter().enumerate() {
                let x = middle(place);
                let ends = [(x - cell / 2, top), (x - cell / 2 + cell, top + cell)];
                area.draw(&Rectangle::new(ends, rgb(cell_of_row.color).filled()))?;
                area.draw(&Rectangle::new(ends, WHITE.stroke_width(2)))?;
                let at = (x, top + (cell - line_height(TEXT) as i32) / 2);
                let ink = readable_on(cell_of_row.color);
                let ink = style(TEXT, HPos::Center).color(&ink);
                draw_line(area, &cell_of_row.text, &ink, at)?;
            }
            for (x, text) in layout.after.iter().zip(&row.after) {
                let top = line_top(1, TEXT);
                draw_line(area, text, &centred, (*x as i32, top))?;
            }
        }
        let key = (margin, layout.key_top as i32);
        draw_key(area, &layout.key, key, TEXT)
    }
}

/// The colour of text on a box.
fn readable_on(color: Rgba) -> RGBColor {
    let light = 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
    if light < 0.4 { WHITE } else { INK }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_end_before_the_boxes_and_rows_do_not_overlap() {
        let grey = Rgba::opaque([0.5; 3]);
        let row = |label: &str, boxes| Strip {
            label: label.into(),
            cells: vec![Cell::new(grey, 7); boxes],
            after: vec!["251".into(), "a longer text".into()],
        };
        let long = "a row with a label that is so long that it has to be broken into two lines or even more";
        let strips = Strips {
            title: long.repeat(2),
            heads: [Vec::new(), vec!["stencil".into(), "depth".into()]],
            rows: vec![row("short", 12), Strip::heading("a heading"), row(long, 3)],
            cell: 30,
            key: Key::default(),
        };
        let layout = Layout::of(&strips);
        let mut free = layout.heads_top + line_height(TEXT);
        for (row, (lines, top, height)) in strips.rows.iter().zip(&layout.rows) {
            assert!(*top >= free, "{}", row.label);
            free = top + height;
            assert!(*height >= lines.len() as u32 * line_height(TEXT));
            for line in lines {
                assert!(MARGIN + width_of(line, TEXT) < layout.cells, "{line}");
            }
        }
        assert!(layout.rows[2].0.len() > 1 && layout.key_top >= free);
        let boxes_end = layout.cells + 12 * strips.cell;
        let [first, second] = [layout.after[0], layout.after[1]];
        assert!(first - width_of("stencil", TEXT) / 2 > boxes_end);
        let room = width_of("stencil", TEXT) / 2 + width_of("a longer text", TEXT) / 2;
        assert!(second - first > room);
        assert!(second + width_of("a longer text", TEXT) / 2 < layout.size.0);
        assert!(layout.title.len() > 1);
    }

    #[test]
    fn text_on_a_box_is_light_where_the_box_is_dark() {
        assert_eq!(readable_on(Rgba::opaque([0.0, 0.1, 0.3])), WHITE);
        assert_eq!(readable_on(Rgba::opaque([0.9, 0.9, 0.3])), INK);
    }
}
