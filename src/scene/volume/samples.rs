//! Bytes of a file become samples.

use std::io::{self, ErrorKind, Read};

use super::check::Fault;

/// How a file stores a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SampleType {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

/// In which order a sample's bytes are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Endian {
    Little,
    Big,
}

impl SampleType {
    /// Bytes of one sample.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Appends whole samples as the nearest f32. 8 and 16 bits are exact; those with more are rounded.
    fn convert(self, bytes: &[u8], endian: Endian, samples: &mut Vec<f32>) {
        macro_rules! read {
            ($type:ty) => {
                read(bytes, samples, |sample| match endian {
                    Endian::Little => <$type>::from_le_bytes(sample) as f32,
                    Endian::Big => <$type>::from_be_bytes(sample) as f32,
                })
            };
        }
        match self {
            Self::I8 => read!(i8),
            Self::U8 => read!(u8),
            Self::I16 => read!(i16),
            Self::U16 => read!(u16),
            Self::I32 => read!(i32),
            Self::U32 => read!(u32),
            Self::I64 => read!(i64),
            Self::U64 => read!(u64),
            Self::F32 => read!(f32),
            Self::F64 => read_f64(bytes, endian, samples),
        }
    }
}

fn read<const N: usize>(bytes: &[u8], samples: &mut Vec<f32>, convert: impl Fn([u8; N]) -> f32) {
    let (whole, _) = bytes.as_chunks();
    samples.extend(whole.iter().map(|&sample| convert(sample)));
}

fn read_f64(bytes: &[u8], endian: Endian, samples: &mut Vec<f32>) {
    read(bytes, samples, |sample| {
        nearest(match endian {
            Endian::Little => f64::from_le_bytes(sample),
            Endian::Big => f64::from_be_bytes(sample),
        })
    });
}

/// The nearest f32. A finite number stays one.
pub(super) fn nearest(number: f64) -> f32 {
    if number.is_finite() {
        number.clamp(f32::MIN.into(), f32::MAX.into()) as f32
    } else {
        number as f32
    }
}

/// What a header says about its samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) dims: [usize; 3],
    pub(super) stored: SampleType,
    pub(super) endian: Endian,
}

/// How much is converted at a time: a whole number of samples of every type.
const PIECE: usize = 1 << 16;

impl Layout {
    /// How many samples there are. The dims have been checked, so that this and the bytes stay in range.
    pub(super) fn count(&self) -> usize {
        self.dims.iter().product()
    }

    /// Bytes of all samples.
    pub(super) fn bytes(&self) -> usize {
        self.count() * self.stored.size()
    }

    /// There must be at least so many bytes as the samples take.
    pub(super) fn expect(&self, found: usize) -> Result<(), Fault> {
        if found >= self.bytes() {
            return Ok(());
        }
        let [x, y, z] = self.dims;
        Err((
            format!(
                "{x} x {y} x {z} samples of {} bytes are {} bytes, but there are {found}",
                self.stored.size(),
                self.bytes()
            ),
            "The file is cut off, or its header belongs to another one: get it again.",
        ))
    }

    /// Appends the samples, fewer if fewer are there; gives the number of bytes that were read. Nothing is kept of what is
    /// unpacked but the samples, and no more is unpacked than these.
    pub(super) fn read(&self, source: impl Read, samples: &mut Vec<f32>) -> io::Result<usize> {
        let wanted = self.bytes();
        let mut source = source.take(wanted as u64);
        let mut piece = vec![0; PIECE.min(wanted)];
        let mut read = 0;
        loop {
            let length = fill(&mut source, &mut piece)?;
            self.stored.convert(&piece[..length], self.endian, samples);
            read += length;
            if length < piece.len() || read == wanted {
                return Ok(read);
            }
        }
    }
}

/// As much as there is; less than the buffer's length only at the end.
fn fill(source: &mut impl Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut filled = 0;
    while filled < buffer.len() {
        match source.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(length) => filled += length,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(filled)
}

/// Makes room for so many more samples, at once, so that there is never more of it. To be called when the bytes that are
/// there can hold as many: a header's word is not enough.
pub(super) fn make_room(samples: &mut Vec<f32>, count: usize) -> Result<(), Fault> {
    samples.try_reserve_exact(count).map_err(|_| {
        let size = (count * size_of::<f32>()) >> 20;
        (
            format!("{count} samples take {size} MiB of memory, and the system does not give them"),
            "Crop it or take every other sample.",
        )
    })
}

/// A number as people and programs write it, with what C libraries print for those that are none: `nan`, `-inf`,
/// `1.#INF`, `-1.#IND`, `nan(ind)`.
pub(super) fn number(word: &str) -> Option<f64> {
    if let Ok(number) = word.parse() {
        return Some(number);
    }
    let lower = word.to_ascii_lowercase();
    let (sign, size) = match lower.strip_prefix('-') {
        Some(size) => (-1.0, size),
        None => (1.0, lower.strip_prefix('+').unwrap_or(&lower)),
    };
    let named = |names: &[&str]| names.iter().any(|name| size.starts_with(name));
    if named(&["1.#inf"]) {
        Some(sign * f64::INFINITY)
    } else if named(&["1.#qnan", "1.#snan", "1.#ind", "1.#nan", "nan("]) {
        Some(f64::NAN)
    } else {
        None
    }
}

/// Appends the numbers of a text.
///
/// # Errors
/// The first word that is not a number.
pub(super) fn numbers<'t>(
    words: impl Iterator<Item = &'t str>,
    samples: &mut Vec<f32>,
) -> Result<(), &'t str> {
    for word in words {
        samples.push(nearest(number(word).ok_or(word)?));
    }
    Ok(())
}
