//! Pictures: float pixels, their files, and the differences of two pictures.

mod compare;
mod file;
mod load;
mod output;
mod resemblance;

pub use compare::{Comparison, difference_picture};
pub(crate) use compare::{difference, differences_alone};
pub use file::{Encoding, FileKind};
pub(crate) use output::write_whole;
pub use output::{UNFINISHED, check_writable};
pub use resemblance::{NEARLY_ALL, Resemblance, resemblance};

use crate::fragment::Rgba;

/// A picture. Pixels are linear, and rows go from top to bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The pixels, row by row from the top, each row from the left.
    pub pixels: Vec<Rgba>,
}

impl Image {
    /// A picture of one colour.
    pub fn filled(width: u32, height: u32, color: Rgba) -> Self {
        Self {
            width,
            height,
            pixels: vec![color; width as usize * height as usize],
        }
    }

    /// A picture from texels in GL's order, with the bottom row first.
    ///
    /// # Panics
    /// If there are not `width x height` texels.
    pub fn from_bottom_up(width: u32, height: u32, texels: &[[f32; 4]]) -> Self {
        assert_eq!(
            texels.len(),
            width as usize * height as usize,
            "a texel for each pixel"
        );
        let rows = texels.chunks_exact(width as usize).rev();
        Self {
            width,
            height,
            pixels: rows.flatten().map(|&texel| texel.into()).collect(),
        }
    }

    /// The pixel in column `x` from the left and row `y` from the top.
    ///
    /// # Panics
    /// If there is no such pixel.
    pub fn pixel(&self, x: u32, y: u32) -> Rgba {
        assert!(x < self.width, "column {x} of {}", self.width);
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Pictures side by side, tops aligned, `gap` pixels of `color` between them.
    pub fn beside(pictures: &[&Self], gap: u32, color: Rgba) -> Self {
        let height = pictures
            .iter()
            .map(|picture| picture.height)
            .max()
            .unwrap_or(0);
        let gaps = gap * (pictures.len() as u32).saturating_sub(1);
        let width = pictures.iter().map(|picture| picture.width).sum::<u32>() + gaps;
        let mut all = Self::filled(width, height, color);
        let mut left = 0;
        for picture in pictures {
            for (y, row) in picture
                .pixels
                .chunks_exact((picture.width as usize).max(1))
                .enumerate()
            {
                let start = y * width as usize + left as usize;
                all.pixels[start..start + row.len()].copy_from_slice(row);
            }
            left += picture.width + gap;
        }
        all
    }

    /// Pictures in rows of `columns`.
    pub fn grid(pictures: &[&Self], columns: usize, gap: u32, color: Rgba) -> Self {
        let rows: Vec<_> = pictures
            .chunks(columns.max(1))
            .map(|row| Self::beside(row, gap, color))
            .collect();
        // Rows below each other are made as columns beside each other, and transposed.
        let transposed: Vec<_> = rows.iter().map(Self::transposed).collect();
        Self::beside(&transposed.iter().collect::<Vec<_>>(), gap, color).transposed()
    }

    fn transposed(&self) -> Self {
        let pixels = (0..self.width).flat_map(|x| (0..self.height).map(move |y| self.pixel(x, y)));
        Self {
            width: self.height,
            height: self.width,
            pixels: pixels.collect(),
        }
    }
}
