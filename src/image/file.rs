//! Picture files: PNG in 8 bits, EXR in 32-bit float. Written whole or not at all.

use std::io::{BufWriter, Cursor, Write};
use std::path::Path;

use image::{DynamicImage, ImageFormat, ImageReader, Rgba32FImage, RgbaImage};

use super::Image;
use crate::error::{Error, Place, Result};
use crate::fragment::Rgba;

/// What the numbers of an 8-bit picture mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// The linear values as they are: VTK's convention, so that pictures compare.
    #[default]
    Linear,
    /// Encoded for a display (sRGB). Alpha is never encoded.
    Srgb,
}

/// A kind of picture file, by its ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// `.png`: four channels of 8 bits.
    Png,
    /// `.exr`: four channels of 32-bit float.
    Exr,
}

/// The largest picture that is read: 2 GiB, more than any driver's largest image takes on the disk.
const MAX_BYTES: u64 = 2 << 30;

impl FileKind {
    /// The kind that a file's name says.
    ///
    /// # Errors
    /// If it says none.
    pub fn of(path: &Path) -> Result<Self> {
        match path
            .extension()
            .and_then(|ending| ending.to_str())
            .map(str::to_ascii_lowercase)
            .as_deref()
        {
            Some("png") => Ok(Self::Png),
            Some("exr") => Ok(Self::Exr),
            _ => Err(Error::usage(
                format!("{}: this is not the name of a picture", path.display()),
                "name it .png (8 bits) or .exr (32-bit float)",
            )),
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

    /// Writes the picture as its name says, `.png` or `.exr`; an EXR is always linear. The file appears only when it
    /// is whole.
    ///
    /// # Errors
    /// If the name says neither, or the file cannot be written; what was there before is then still there.
    pub fn save_as(&self, path: impl AsRef<Path>, encoding: Encoding) -> Result<()> {
        let path = path.as_ref();
        let (picture, format) = match FileKind::of(path)? {
            FileKind::Png => (self.to_bytes(encoding), ImageFormat::Png),
            FileKind::Exr => (self.to_floats(), ImageFormat::OpenExr),
        };
        write_whole(path, |file| {
            // The encoders want to seek; a buffer lets them.
            let mut buffer = Cursor::new(Vec::new());
            picture
                .write_to(&mut buffer, format)
                .map_err(|e| e.to_string())?;
            file.write_all(buffer.get_ref()).map_err(|e| e.to_string())
        })
    }

    /// Reads a `.png` or `.exr`. 8-bit values are taken as linear.
    ///
    /// # Errors
    /// If the file is not there or is not what its name says.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let format = match FileKind::of(path)? {
            FileKind::Png => ImageFormat::Png,
            FileKind::Exr => ImageFormat::OpenExr,
        };
        let wrong =
            |what: String| Error::input(Place::file(path), what, "give a PNG or EXR picture");
        let metadata = std::fs::metadata(path);
        let metadata = metadata.map_err(|e| wrong(format!("cannot read it: {e}")))?;
        if !metadata.is_file() || metadata.len() > MAX_BYTES {
            let what = format!("this is no file of at most {MAX_BYTES} bytes");
            return Err(wrong(what));
        }
        let bytes = std::fs::read(path).map_err(|e| wrong(format!("cannot read it: {e}")))?;
        let picture = ImageReader::with_format(Cursor::new(bytes), format).decode();
        let picture = picture
            .map_err(|e| wrong(format!("cannot decode it: {e}")))?
            .into_rgba32f();
        let (width, height) = picture.dimensions();
        Ok(Self {
            width,
            height,
            pixels: picture.pixels().map(|pixel| pixel.0.into()).collect(),
        })
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

/// IEC 61966-2-1's encoding of a linear value.
fn srgb(linear: f32) -> f32 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

/// Writes a file beside its place and moves it there when it is whole.
pub(crate) fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut tempfile::NamedTempFile>) -> Result<(), String>,
) -> Result<()> {
    let wrong = |what: String| unwritable(path, what);
    let folder = folder_for(path)?;
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // A temporary file is private by default; a picture is as public as the user's umask lets it.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder
        .prefix(UNFINISHED)
        .tempfile_in(folder)
        .map_err(|e| wrong(e.to_string()))?;
    let mut buffer = BufWriter::new(&mut file);
    write(&mut buffer)
        .and_then(|()| buffer.flush().map_err(|e| e.to_string()))
        .map_err(wrong)?;
    drop(buffer);
    file.persist(path).map_err(|e| wrong(e.error.to_string()))?;
    Ok(())
}

/// How the names of files begin that are not whole yet. Only a killed program leaves one behind.
pub const UNFINISHED: &str = ".onionskin-";

/// Asks, before a long computation, whether its result could be written to `path`.
///
/// # Errors
/// If it could not.
pub fn check_writable(path: &Path) -> Result<()> {
    tempfile::Builder::new()
        .prefix(UNFINISHED)
        .tempfile_in(folder_for(path)?)
        .map_err(|e| unwritable(path, e.to_string()))?;
    Ok(())
}

/// The folder in which a file is to appear.
fn folder_for(path: &Path) -> Result<&Path> {
    if path.is_dir() {
        return Err(unwritable(path, "there is a folder of that name".into()));
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    if folder.as_os_str().is_empty() {
        return Ok(Path::new("."));
    }
    if !folder.is_dir() {
        let what = format!("there is no folder {}", folder.display());
        return Err(unwritable(path, what));
    }
    Ok(folder)
}

fn unwritable(path: &Path, what: String) -> Error {
    Error::Output {
        path: path.to_owned(),
        what,
        remedy:
            "check that the folder exists, that you may write there, and that the disk has room"
                .into(),
    }
}
