//! NRRD: a text header, and the samples after it (`.nrrd`) or in files of their own (`.nhdr`).
//!
//! Source: the format's definition, <https://teem.sourceforge.net/nrrd/format.html>. Arrays of three axes with more
//! than one sample can be read, of every type but `block`, with the encodings `raw`, `gzip`, `hex` and `ascii`. The
//! samples may be in one file or in several, which are listed or numbered. If `space` names the patient's axes, the
//! volume is turned into the world's, right-anterior-superior. Otherwise the file's own space is the world.

mod axes;
mod encoding;
mod files;
mod header;
mod placement;
mod types;

use std::path::Path;

use super::reading::{Loaded, Parts, Wish};
use super::samples::{Endian, Layout, SampleType, make_room};
use crate::error::Result;
use axes::Axes;
use encoding::Encoding;
use files::Files;
use header::Header;

pub(super) fn read(path: &Path, bytes: &[u8], wish: &Wish) -> Result<Loaded> {
    let header = Header::parse(path, bytes)?;
    let axes = Axes::read(&header)?;
    let stored = types::stored(&header.required("type")?.text).ok_or_else(|| {
        header.wrong(
            "type",
            "this is not a type of samples that can be read",
            "Known are the integers of 8 to 64 bits, such as uint8 or short, and float and double.",
        )
    })?;
    let encoding = Encoding::of(&header)?;
    let layout = Layout {
        dims: axes.dims(),
        stored,
        endian: endian(&header, stored, encoding)?,
    };
    let files = Files::of(&header, &axes)?;
    let stored = files.stored(&header, bytes);
    wish.expect_room(layout.count(), stored, header.place("sizes"))?;
    let samples = samples(&header, &layout, encoding, &files, bytes, wish)?;
    let placement = placement::read(&header, &axes)?;
    let mut notices = header.notices();
    notices.extend(placement.space.and_then(|space| space.notice(path)));
    Parts {
        path,
        dims: layout.dims,
        samples,
        index_to_world: placement.affine,
        placed_by: header.place(placement.field),
        notices,
    }
    .finish(wish)
}

fn samples(
    header: &Header,
    layout: &Layout,
    encoding: Encoding,
    files: &Files,
    bytes: &[u8],
    wish: &Wish,
) -> Result<Vec<f32>> {
    // The layout of a file's part. For a single file, an error about missing bytes says the volume's shape.
    let dims = match files.count() {
        1 => layout.dims,
        parts => [layout.count() / parts, 1, 1],
    };
    let part = Layout { dims, ..*layout };
    expect_little_to_skip(header, files)?;
    let mut samples = Vec::new();
    if let Files::Attached = files {
        encoding.read(header, &part, &bytes[header.end..], &mut samples)?;
    }
    for path in files.paths(header) {
        let data = wish.read(&path?)?;
        encoding.read(header, &part, &data, &mut samples)?;
        if samples.capacity() < layout.count() {
            let more = layout.count() - samples.len();
            make_room(&mut samples, more)
                .map_err(|(what, remedy)| header.wrong("sizes", what, remedy))?;
        }
    }
    Ok(samples)
}

/// Checks the bytes to skip in packed samples. They have to be unpacked in each of the files, and all of them may be
/// the same file.
fn expect_little_to_skip(header: &Header, files: &Files) -> Result<()> {
    const MOST: u64 = 1 << 30;
    let skip = header.integer("byte skip")?.unwrap_or(0);
    let skip = u64::try_from(skip).unwrap_or(0);
    if files.count() == 1 || skip.saturating_mul(files.count() as u64) <= MOST {
        return Ok(());
    }
    let what = format!("{} times these are more than {MOST} bytes", files.count());
    Err(header.wrong("byte skip", what, "Save the volume without them."))
}

fn endian(header: &Header, stored: SampleType, encoding: Encoding) -> Result<Endian> {
    let matters = stored.size() > 1 && encoding.has_bytes();
    let Some(field) = header.optional("endian") else {
        if !matters {
            return Ok(Endian::Little);
        }
        return header.required("endian").map(|_| Endian::Little);
    };
    match field.text.to_ascii_lowercase().as_str() {
        "little" => Ok(Endian::Little),
        "big" => Ok(Endian::Big),
        _ if !matters => Ok(Endian::Little),
        _ => Err(header.wrong(
            "endian",
            "this is not an order of bytes",
            "Write little or big.",
        )),
    }
}
