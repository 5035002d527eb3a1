//! NRRD: a text header, and the samples after it (`.nrrd`) or in a file of their own (`.nhdr`).
//!
//! After the format's definition, <https://teem.sourceforge.net/nrrd/format.html>. Read are three-dimensional arrays of
//! every type but `block`, encodings `raw` and `gzip`, one data file. World space is the file's own space, whatever it
//! calls its axes.

mod header;
mod placement;

use std::path::Path;

use super::check;
use super::gzip;
use super::load::{Layout, Loaded, finish};
use super::samples::{Endian, SampleType};
use crate::error::Result;
use crate::memory::MemoryLimit;
use crate::scene::source;
use header::Header;

pub(super) fn read(path: &Path, bytes: &[u8], memory: &MemoryLimit) -> Result<Loaded> {
    let header = Header::parse(path, bytes)?;
    let layout = layout(&header)?;
    let samples = match header.optional("data file") {
        None => unpack(&header, &layout, &bytes[header.end..])?,
        Some(field) => {
            let name = field.text.as_str();
            if name == "LIST" || name.starts_with("LIST ") || name.contains('%') {
                let what = "the samples are spread over several files";
                return Err(header.wrong("data file", what, "Join them into one file."));
            }
            let folder = path.parent().unwrap_or(Path::new(""));
            let data = source::read_bytes(&folder.join(name), memory)?;
            unpack(&header, &layout, &data)?
        }
    };
    let samples = layout.stored.convert(&samples, layout.endian);
    let placement = placement::read(&header)?;
    let places = [header.place("data file"), header.place(placement.field)];
    let volume = finish(path, layout.dims, samples, placement.affine, places)?;
    Ok(Loaded {
        volume,
        notices: header.notices(),
    })
}

fn layout(header: &Header) -> Result<Layout> {
    let dimension = header.required("dimension")?;
    if dimension.text != "3" {
        let what = format!("the array has the dimension {}", dimension.text);
        return Err(header.wrong("dimension", what, "Give a three-dimensional array."));
    }
    let dims = header.three("sizes", "three whole numbers", |word| {
        word.parse::<usize>().ok()
    })?;
    check::dims(dims).map_err(|(what, remedy)| header.wrong("sizes", what, remedy))?;
    let stored = stored(&header.required("type")?.text).ok_or_else(|| {
        header.wrong(
            "type",
            "this is not a type of samples that can be read",
            "Known are the integers of 8 to 64 bits, such as uint8 or short, and float and double.",
        )
    })?;
    Ok(Layout {
        dims,
        stored,
        endian: endian(header, stored)?,
    })
}

/// The samples' bytes: those of `data` that the header means, unpacked.
fn unpack(header: &Header, layout: &Layout, data: &[u8]) -> Result<Vec<u8>> {
    let data = skip_lines(header, data)?;
    let skip = header.integer("byte skip")?.unwrap_or(0);
    let wanted = layout.bytes();
    let short = |found: usize| {
        let fault = layout.expect(found);
        fault.map_err(|(what, remedy)| header.wrong("sizes", what, remedy))
    };
    let skipped = |skip: i64, bytes: usize| {
        let skip = usize::try_from(skip).ok().filter(|&skip| skip <= bytes);
        skip.ok_or_else(|| {
            let what = format!("{bytes} bytes are there");
            header.wrong("byte skip", what, "Skip fewer of them.")
        })
    };
    match header
        .required("encoding")?
        .text
        .to_ascii_lowercase()
        .as_str()
    {
        "raw" => {
            // -1: whatever comes before the samples at the file's end.
            let start = if skip == -1 {
                data.len().saturating_sub(wanted)
            } else {
                skipped(skip, data.len())?
            };
            short(data.len() - start)?;
            Ok(data[start..start + wanted].to_vec())
        }
        "gzip" | "gz" => {
            let start = skipped(skip, usize::MAX - wanted)?;
            let total = start as u64 + wanted as u64;
            if !gzip::can_hold(data.len(), total) {
                short(0)?;
            }
            let mut bytes = gzip::unpack(data, start + wanted).map_err(|error| {
                let what = format!("the samples do not unpack: {error}");
                header.wrong(
                    "encoding",
                    what,
                    "The file is damaged or cut off: get it again.",
                )
            })?;
            short(bytes.len().saturating_sub(start))?;
            bytes.drain(..start);
            Ok(bytes)
        }
        _ => Err(header.wrong(
            "encoding",
            "this is not an encoding that can be read",
            "Save the volume as raw or gzip.",
        )),
    }
}

fn skip_lines<'a>(header: &Header, mut data: &'a [u8]) -> Result<&'a [u8]> {
    let lines = header.integer("line skip")?.unwrap_or(0);
    for _ in 0..lines.max(0) {
        let Some(end) = data.iter().position(|&byte| byte == b'\n') else {
            return Err(header.wrong("line skip", "there are fewer lines", "Skip fewer of them."));
        };
        data = &data[end + 1..];
    }
    Ok(data)
}

fn endian(header: &Header, stored: SampleType) -> Result<Endian> {
    let Some(field) = header.optional("endian") else {
        if stored.size() == 1 {
            return Ok(Endian::Little);
        }
        return header.required("endian").map(|_| Endian::Little);
    };
    match field.text.to_ascii_lowercase().as_str() {
        "little" => Ok(Endian::Little),
        "big" => Ok(Endian::Big),
        _ => Err(header.wrong(
            "endian",
            "this is not an order of bytes",
            "Write little or big.",
        )),
    }
}

/// The format's names of its types.
fn stored(name: &str) -> Option<SampleType> {
    Some(match name {
        "signed char" | "int8" | "int8_t" => SampleType::I8,
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => SampleType::U8,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => {
            SampleType::I16
        }
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => {
            SampleType::U16
        }
        "int" | "signed int" | "int32" | "int32_t" => SampleType::I32,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => SampleType::U32,
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => SampleType::I64,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
            SampleType::U64
        }
        "float" => SampleType::F32,
        "double" => SampleType::F64,
        _ => return None,
    })
}
