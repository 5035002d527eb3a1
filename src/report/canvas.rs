//! The parts that all plots share: one font, and pixels.

use std::sync::Once;

use plotters::style::{FontStyle, register_font};

use crate::fragment::Rgba;
use crate::image::Image;

pub(super) const FAMILY: &str = "sans-serif";

/// The picture in a plotting library's bytes, three per pixel.
pub(super) fn in_pixels((width, height): (u32, u32), bytes: &[u8]) -> Image {
    let pixel = |rgb: &[u8]| Rgba::opaque([0, 1, 2].map(|n| f32::from(rgb[n]) / 255.0));
    Image {
        width,
        height,
        pixels: bytes.chunks_exact(3).map(pixel).collect(),
    }
}

/// Makes [`FAMILY`] known to the plotting library.
pub(super) fn register_the_font() {
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
