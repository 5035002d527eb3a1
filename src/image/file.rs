//! Picture files: PNG in 8 bits, EXR in 32-bit float. A file is written whole or not at all.

use std::io::Cursor;
use std::path::Path;

use image::{DynamicImage, ImageFormat, Rgba32FImage, RgbaImage};

use super::Image;
use super::output::write_whole;
use crate::error::{Error, Result};
use crate::fragment::Rgba;

/// The meaning of the numbers of an 8-bit picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Encoding {
    /// The linear values as they are. This is VTK's convention, so that pictures can be compared.
    #[default]
    Linear,
    /// Values encoded for a display (sRGB). Alpha is never encoded.
    Srgb,
}

/// A kind of picture file, as the ending of its name says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum FileKind {
    /// `.png`: four channels of 8 bits.
    Png,
    /// `.exr`: four channels of 32-bit float.
    Exr,
}

impl FileKind {
    /// The kind of a file, by its name.
    ///
    /// # Errors
    /// If the name has neither ending.
    pub fn of(path: &Path) -> Result<Self> {
        match path
            .extension()
            .and_then(|ending| ending.to_str())
            .map(str::to_ascii_lowercase)
            .as_deref()
        {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            _ => Err(Error::FileName {
                path: path.to_owned(),
                kind: "picture",
                remedy: "name it .png (8 bits) or .exr (32-bit float)",
            }),
        }
    }
}

impl Image {
    /// Writes the picture, 8-bit values linear. See [`Image::save_as`].
    ///
    /// # Errors
    /// As [`Image::save_as`].
    pub fn save(&self, path: impl AsRef<Path>) -> Result<()> {
        self.save_as(path, Encoding::Linear)
    }

    /// Writes the picture as a PNG or an EXR, by the ending of `path`. An EXR is always linear. The file appears only
    /// when it is whole.
    ///
    /// # Errors
    /// If the name has neither ending, or the file cannot be written. What was there before is then still there.
    pub fn save_as(&self, path: impl AsRef<Path>, encoding: Encoding) -> Result<()> {
        let path = path.as_ref();
        let (picture, format) = match FileKind::of(path)? {
            FileKind::Png => (self.to_bytes(encoding), ImageFormat::Png),
            FileKind::Exr => (self.to_floats(), ImageFormat::OpenExr),
        };
        let bytes = encoded(&picture, format).map_err(|what| Error::Output {
            path: path.to_owned(),
            what,
            remedy: "render it smaller, or as another kind of picture".into(),
            source: None,
        })?;
        write_whole(path, &bytes)
    }

    /// The bytes of a PNG, 8-bit values linear, or why it cannot be one.
    #[cfg(feature = "report")]
    pub(crate) fn to_png(&self) -> Result<Vec<u8>, String> {
        encoded(&self.to_bytes(Encoding::Linear), ImageFormat::Png)
    }

    fn to_bytes(&self, encoding: Encoding) -> DynamicImage {
        let encode = match encoding {
            Encoding::Linear => |value: f32| value,
            Encoding::Srgb => srgb,
        };
        // As OpenGL converts to normalised fixed point: clamped, then rounded to nearest. NaN becomes 0.
        let byte = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
        let bytes = self.pixels.iter().flat_map(|&Rgba { r, g, b, a }| {
            [byte(encode(r)), byte(encode(g)), byte(encode(b)), byte(a)]
        });
        let picture = RgbaImage::from_raw(self.width, self.height, bytes.collect());
        DynamicImage::ImageRgba8(picture.expect("four bytes for each pixel"))
    }

    fn to_floats(&self) -> DynamicImage {
        let floats = bytemuck::cast_slice(&self.pixels).to_vec();
        let picture = Rgba32FImage::from_raw(self.width, self.height, floats);
        DynamicImage::ImageRgba32F(picture.expect("four floats for each pixel"))
    }
}

fn encoded(picture: &DynamicImage, format: ImageFormat) -> Result<Vec<u8>, String> {
    // The encoders need to seek, which a buffer allows.
    let mut buffer = Cursor::new(Vec::new());
    let written = picture.write_to(&mut buffer, format);
    written.map_err(|error| error.to_string())?;
    Ok(buffer.into_inner())
}

/// IEC 61966-2-1's encoding of a linear value.
pub(super) fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}
