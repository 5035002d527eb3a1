//! The encoding of a file's samples: raw, packed, as hexadecimal digits or as decimal numbers.

use std::io::{self, Read};

use super::header::Header;
use crate::error::{Error, Result};
use crate::scene::volume::gzip;
use crate::scene::volume::samples::{Layout, make_room, numbers};

/// An encoding that can be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Gzip,
    Hex,
    Text,
}

const AGAIN: &str = "The file is damaged or cut off: get it again.";

impl Encoding {
    pub(super) fn of(header: &Header) -> Result<Self> {
        let name = header.required("encoding")?.text.to_ascii_lowercase();
        Ok(match name.as_str() {
            "raw" => Self::Raw,
            "gzip" | "gz" => Self::Gzip,
            "hex" => Self::Hex,
            "ascii" | "text" | "txt" => Self::Text,
            _ => {
                let what = match name.as_str() {
                    "bzip2" | "bz2" => "the samples are packed by bzip2, which is not read",
                    "zrl" => "the samples are run lengths (ZRL), which are not read",
                    _ => "this is not an encoding that can be read",
                };
                let remedy = "Save the volume as raw, gzip, hex or ascii.";
                return Err(header.wrong("encoding", what, remedy));
            }
        })
    }

    /// Whether the order of a sample's bytes matters.
    pub(super) fn has_bytes(self) -> bool {
        self != Self::Text
    }

    /// Appends the samples of a file. `layout` is the layout of this file's part.
    pub(super) fn read(
        self,
        header: &Header,
        layout: &Layout,
        data: &[u8],
        samples: &mut Vec<f32>,
    ) -> Result<()> {
        let data = skip_lines(header, data)?;
        let skip = Skip::of(header)?;
        match self {
            Self::Raw => {
                let start = skip.within(header, data.len(), layout)?;
                expect(header, layout, data.len() - start)?;
                room(header, layout, samples)?;
                take(header, layout, &data[start..], samples).map(drop)
            }
            Self::Gzip => {
                let start = skip.of_stream(header)?;
                let total = start.saturating_add(layout.bytes() as u64);
                if !gzip::can_hold(data.len() as u64, total) {
                    expect(header, layout, 0)?;
                }
                room(header, layout, samples)?;
                let mut unpacker = gzip::unpack(data);
                let skipped = io::copy(&mut unpacker.by_ref().take(start), &mut io::sink());
                skipped.map_err(|error| damaged(header, &error))?;
                let found = take(header, layout, unpacker, samples)?;
                expect(header, layout, found)
            }
            Self::Hex => {
                let start = skip.within(header, data.len(), layout)?;
                // An upper bound: there may be white space among the digits.
                expect(header, layout, (data.len() - start) / 2)?;
                room(header, layout, samples)?;
                let mut digits = Digits {
                    text: &data[start..],
                };
                let found = take(header, layout, &mut digits, samples)?;
                expect(header, layout, found)
            }
            Self::Text => {
                let start = skip.within(header, data.len(), layout)?;
                text(header, layout, &data[start..], samples)
            }
        }
    }
}

fn room(header: &Header, layout: &Layout, samples: &mut Vec<f32>) -> Result<()> {
    if samples.capacity() - samples.len() >= layout.count() {
        return Ok(());
    }
    let fault = make_room(samples, layout.count());
    fault.map_err(|(what, remedy)| header.wrong("sizes", what, remedy))
}

/// The samples that there are, and the number of their bytes.
fn take(
    header: &Header,
    layout: &Layout,
    source: impl Read,
    samples: &mut Vec<f32>,
) -> Result<usize> {
    let read = layout.read(source, samples);
    read.map_err(|error| damaged(header, &error))
}

fn damaged(header: &Header, error: &io::Error) -> Error {
    let what = format!("the samples do not unpack: {error}");
    header.wrong("encoding", what, AGAIN)
}

fn expect(header: &Header, layout: &Layout, found: usize) -> Result<()> {
    let fault = layout.expect(found);
    fault.map_err(|(what, remedy)| header.wrong("sizes", what, remedy))
}

fn text(header: &Header, layout: &Layout, data: &[u8], samples: &mut Vec<f32>) -> Result<()> {
    let Ok(text) = str::from_utf8(data) else {
        let what = "the samples are said to be text, and they are not";
        return Err(header.wrong("encoding", what, AGAIN));
    };
    let wanted = layout.count();
    let short = |found: usize| {
        let what = format!("there are {found} numbers for {wanted} samples");
        header.wrong("sizes", what, AGAIN)
    };
    // Each sample takes at least a digit and, except the last, a space.
    let most = text.len().div_ceil(2);
    if most < wanted {
        return Err(short(text.split_whitespace().count()));
    }
    room(header, layout, samples)?;
    let before = samples.len();
    let words = text.split(|c: char| c.is_whitespace() || c == ',');
    let words = words.filter(|word| !word.is_empty()).take(wanted);
    numbers(words, samples).map_err(|word| {
        let shown: String = word.chars().take(20).collect();
        let what = format!("'{shown}' among the samples is not a number");
        header.wrong("encoding", what, AGAIN)
    })?;
    match samples.len() - before {
        found if found < wanted => Err(short(found)),
        _ => Ok(()),
    }
}

/// The bytes before the samples, which are skipped.
#[derive(Clone, Copy)]
enum Skip {
    Bytes(u64),
    /// Everything before the samples, which are at the file's end.
    ToTheEnd,
}

impl Skip {
    fn of(header: &Header) -> Result<Self> {
        let skip = header.integer("byte skip")?.unwrap_or(0);
        Ok(u64::try_from(skip).map_or(Self::ToTheEnd, Self::Bytes))
    }

    fn within(self, header: &Header, found: usize, layout: &Layout) -> Result<usize> {
        match self {
            Self::ToTheEnd => {
                if Encoding::of(header)? != Encoding::Raw {
                    return Err(only_raw(header));
                }
                Ok(found.saturating_sub(layout.bytes()))
            }
            Self::Bytes(skip) => usize::try_from(skip)
                .ok()
                .filter(|&skip| skip <= found)
                .ok_or_else(|| {
                    let what = format!("{found} bytes are there");
                    header.wrong("byte skip", what, "Skip fewer of them.")
                }),
        }
    }

    /// Skips unpacked bytes, whose total number is not known.
    fn of_stream(self, header: &Header) -> Result<u64> {
        match self {
            Self::ToTheEnd => Err(only_raw(header)),
            Self::Bytes(skip) => Ok(skip),
        }
    }
}

fn only_raw(header: &Header) -> Error {
    let what = "-1 is for raw samples only, whose length is known";
    header.wrong("byte skip", what, "Give the number of bytes.")
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

/// Bytes of two hexadecimal digits each; white space between them has no meaning.
struct Digits<'a> {
    text: &'a [u8],
}

impl Digits<'_> {
    fn next(&mut self) -> Option<Result<u8, u8>> {
        loop {
            let (&digit, rest) = self.text.split_first()?;
            self.text = rest;
            if !digit.is_ascii_whitespace() {
                let value = char::from(digit).to_digit(16);
                return Some(value.map(|value| value as u8).ok_or(digit));
            }
        }
    }
}

impl Read for Digits<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let wrong = |digit: u8| {
            let shown = digit.escape_ascii();
            io::Error::other(format!("'{shown}' is not a hexadecimal digit"))
        };
        for (filled, byte) in buffer.iter_mut().enumerate() {
            let Some(high) = self.next() else {
                return Ok(filled);
            };
            let Some(low) = self.next() else {
                return Err(io::Error::other("the last byte has one digit"));
            };
            *byte = high.map_err(wrong)? << 4 | low.map_err(wrong)?;
        }
        Ok(buffer.len())
    }
}
