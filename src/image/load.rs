//! Reading picture files of other people.
//!
//! A file's header says how large the picture is, and a small file may say that its picture is enormous. So the header
//! is read first, and the memory of the picture is compared with the memory that is left, before anything is decoded.

use std::fs::File;
use std::io::BufReader;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use image::{DynamicImage, ImageFormat, ImageReader, ImageResult, Limits};

use super::{FileKind, Image};
use crate::error::{Error, Place, Result, with_slashes};
use crate::fragment::Rgba;
use crate::memory::MemoryLimit;

/// The largest file that is read: 2 GiB, which is more than the largest image of any driver takes on the disk.
const MAX_BYTES: u64 = 2 << 30;

/// Bytes of memory for each pixel: at most four floats as in the file, the same as floats, and the same as pixels.
const BYTES_PER_PIXEL: u64 = 3 * 16;

/// Bytes of memory for each pixel of a data window: unpacked, and as the wanted channels.
const BYTES_PER_KEPT_PIXEL: u64 = 2 * 16;

impl Image {
    /// Reads a `.png` or `.exr`. 8-bit values are taken as linear.
    ///
    /// # Errors
    /// If the file is missing, is not what its name says, or takes more memory than the machine has.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        Self::load_within(path, &MemoryLimit::of_machine())
    }

    /// Reads the same within a memory limit.
    ///
    /// # Errors
    /// As [`Image::load`].
    pub fn load_within(path: impl AsRef<Path>, memory: &MemoryLimit) -> Result<Self> {
        let path = path.as_ref();
        let format = format_of(path)?;
        let ([width, height], kept) = header(path)?;
        let shown = u64::from(width) * u64::from(height);
        let decoded_first = kept.saturating_mul(BYTES_PER_KEPT_PIXEL);
        let bytes = shown
            .saturating_mul(BYTES_PER_PIXEL)
            .saturating_add(decoded_first);
        memory
            .check(bytes)
            .map_err(|short| short.at(Place::file(path), format!("{width} x {height} pixels")))?;
        let decode = || {
            let mut reader = ImageReader::with_format(open(path)?, format);
            let mut limits = Limits::default();
            limits.max_image_width = Some(width);
            limits.max_image_height = Some(height);
            limits.max_alloc = Some(bytes);
            reader.limits(limits);
            decoded(path, || reader.decode())
        };
        Ok(of_floats(decode()?))
    }

    /// The width and height from the header of a `.png` or `.exr`. Nothing is decoded.
    ///
    /// # Errors
    /// If the file is missing or is not what its name says.
    pub fn size_of_file(path: impl AsRef<Path>) -> Result<[u32; 2]> {
        Ok(header(path.as_ref())?.0)
    }
}

/// The picture's size, and the number of pixels in the data windows of an EXR, for which the decoder takes memory too.
fn header(path: &Path) -> Result<([u32; 2], u64)> {
    let format = format_of(path)?;
    let reader = ImageReader::with_format(open(path)?, format);
    let (width, height) = decoded(path, || reader.into_dimensions())?;
    if width == 0 || height == 0 {
        return Err(wrong(path, format!("it has {width} x {height} pixels")));
    }
    let size = [width, height];
    if format != ImageFormat::OpenExr {
        return Ok((size, 0));
    }
    let kept = data_windows(path)?;
    expect_near(path, size, kept)?;
    Ok((size, kept))
}

fn format_of(path: &Path) -> Result<ImageFormat> {
    Ok(match FileKind::of(path)? {
        FileKind::Png => ImageFormat::Png,
        FileKind::Exr => ImageFormat::OpenExr,
    })
}

/// Opens a file. Folders, and things that block or never end, are refused.
fn open(path: &Path) -> Result<BufReader<File>> {
    let unreadable = |error: std::io::Error| {
        match with_slashes(path) {
            Some(remedy) => Error::input(Place::file(path), "there is no such file", remedy),
            None => wrong(path, format!("cannot read it: {error}")),
        }
        .caused_by(error)
    };
    let there = std::fs::metadata(path).map_err(unreadable)?;
    if !there.is_file() || there.len() > MAX_BYTES {
        let what = format!("this is no file of at most {MAX_BYTES} bytes");
        return Err(wrong(path, what));
    }
    Ok(BufReader::new(File::open(path).map_err(unreadable)?))
}

/// The number of pixels in an EXR file's data windows, which may differ from the picture.
fn data_windows(path: &Path) -> Result<u64> {
    let file = open(path)?;
    let read = || exr::meta::MetaData::read_from_buffered(file, false);
    let damaged = |what: String| wrong(path, format!("cannot decode it: {what}"));
    let meta = catch_unwind(AssertUnwindSafe(read))
        .map_err(|_| damaged("it is damaged".into()))?
        .map_err(|error| damaged(error.to_string()))?;
    let pixels = meta.headers.iter().map(|header| {
        let size = header.layer_size;
        (size.width() as u64).saturating_mul(size.height() as u64)
    });
    Ok(pixels.fold(0, u64::saturating_add))
}

/// # Errors
/// If a file keeps many times the picture's pixels, for all of which the decoder takes memory. A margin around the
/// picture, and a part for each eye or layer, do not explain so many.
fn expect_near(path: &Path, [width, height]: [u32; 2], kept: u64) -> Result<()> {
    /// This many are allowed for any picture.
    const SPARE: u64 = 1 << 20;
    const TIMES: u64 = 64;
    let shown = u64::from(width) * u64::from(height);
    if kept <= SPARE.saturating_add(shown.saturating_mul(TIMES)) {
        return Ok(());
    }
    let what = format!("its data window has {kept} pixels, for a picture of {width} x {height}");
    Err(wrong(path, what))
}

/// Decodes the file. A decoder that panics over damaged bytes counts as having refused them.
fn decoded<T>(path: &Path, decode: impl FnOnce() -> ImageResult<T>) -> Result<T> {
    match catch_unwind(AssertUnwindSafe(decode)) {
        Ok(Ok(picture)) => Ok(picture),
        Ok(Err(error)) => Err(wrong(path, format!("cannot decode it: {error}"))),
        Err(_) => Err(wrong(path, "cannot decode it: it is damaged".into())),
    }
}

fn wrong(path: &Path, what: String) -> Error {
    let remedy = "give a PNG, or an EXR with the channels R, G, B and, if it has one, A";
    Error::input(Place::file(path), what, remedy)
}

fn of_floats(picture: DynamicImage) -> Image {
    let picture = picture.into_rgba32f();
    let (width, height) = picture.dimensions();
    Image {
        width,
        height,
        pixels: picture.pixels().map(|pixel| Rgba::from(pixel.0)).collect(),
    }
}
