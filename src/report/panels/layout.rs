//! Where everything on a sheet is, in pixels from its top left corner.

use crate::report::canvas::{line_height, wrapped};
use crate::report::key::{Entry, Key, key_height};
use crate::report::scale::bar_height;

/// A panel is at least so wide, so that its caption has room.
const NARROWEST: u32 = 320;
/// A small picture is enlarged up to [`NARROWEST`], but not beyond this height.
const TALLEST: u32 = 960;
/// Text is at least so large. At half size it can still be read.
const SMALLEST_TEXT: u32 = 20;

/// What is to be placed.
pub(super) struct Contents<'c> {
    pub(super) title: &'c str,
    pub(super) columns: usize,
    pub(super) panels: Vec<PanelContents>,
    pub(super) key: &'c Key,
}

/// A panel that is to be placed.
pub(super) struct PanelContents {
    /// The picture's width and height.
    pub(super) size: [u32; 2],
    pub(super) caption: String,
    pub(super) has_bar: bool,
}

/// The places of a sheet's parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Layout {
    pub(super) size: (u32, u32),
    pub(super) margin: u32,
    /// The size of captions, ticks and keys.
    pub(super) text: u32,
    pub(super) title_text: u32,
    pub(super) title: Vec<String>,
    pub(super) places: Vec<Place>,
    pub(super) key: (u32, u32),
    pub(super) key_lines: Vec<Vec<Entry>>,
}

/// The place of a panel.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) left: u32,
    pub(super) top: u32,
    /// The picture's size on the sheet, which is `zoom` times its own.
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) zoom: u32,
    pub(super) caption: Vec<String>,
    pub(super) caption_top: u32,
    pub(super) bar_top: u32,
}

impl Layout {
    pub(super) fn of(sheet: &Contents<'_>) -> Self {
        let sizes: Vec<[u32; 3]> = sheet
            .panels
            .iter()
            .map(|panel| enlarged(panel.size))
            .collect();
        // All columns are as wide as the widest picture.
        let column = sizes.iter().map(|[width, ..]| *width).max();
        let column = column.unwrap_or(0).max(NARROWEST);
        let text = (column / 22).max(SMALLEST_TEXT);
        let title_text = text * 5 / 4;
        let (margin, gap) = (text, text);
        let columns = sheet.columns.min(sheet.panels.len()).max(1) as u32;
        let inner = columns * column + (columns - 1) * gap;

        let title = wrapped(sheet.title, title_text, inner);
        let mut top = margin + title.len() as u32 * line_height(title_text) + text / 2;
        let mut places = Vec::new();
        for (panels, sizes) in sheet
            .panels
            .chunks(columns as usize)
            .zip(sizes.chunks(columns as usize))
        {
            let tallest = sizes.iter().map(|[_, height, _]| *height).max();
            let caption_top = top + tallest.unwrap_or(0) + text / 3;
            let captions: Vec<_> = panels
                .iter()
                .map(|panel| wrapped(&panel.caption, text, column))
                .collect();
            let lines = captions.iter().map(Vec::len).max().unwrap_or(0) as u32;
            let bar_top = caption_top + lines * line_height(text) + text / 4;
            let mut left = margin;
            for (caption, &[width, height, zoom]) in captions.into_iter().zip(sizes) {
                places.push(Place {
                    left: left + (column - width) / 2,
                    top,
                    width,
                    height,
                    zoom,
                    caption,
                    caption_top,
                    bar_top,
                });
                left += column + gap;
            }
            let has_bar = panels.iter().any(|panel| panel.has_bar);
            top = bar_top + if has_bar { bar_height(text) } else { 0 } + text / 2;
        }

        let key_lines = sheet.key.lines(text, inner);
        let key = (margin, top);
        let bottom = top + key_height(key_lines.len(), text);
        Self {
            size: (inner + 2 * margin, bottom + margin / 2),
            margin,
            text,
            title_text,
            title,
            places,
            key,
            key_lines,
        }
    }
}

/// A picture's size on the sheet, and by what its own is multiplied.
fn enlarged([width, height]: [u32; 2]) -> [u32; 3] {
    let wider = NARROWEST.div_ceil(width.max(1));
    let taller = TALLEST / height.max(1);
    let zoom = wider.min(taller).max(1);
    [width * zoom, height * zoom, zoom]
}
