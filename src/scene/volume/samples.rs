//! Converting bytes of a file to samples.

use std::io::{self, ErrorKind, Read};

use super::check::Fault;

/// The type in which a file stores a sample.
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

/// The order in which a sample's bytes are stored.
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

    /// Appends samples, each as the nearest f32. Samples of 8 and 16 bits are exact, larger ones are rounded.
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

/// The nearest f32. A finite number stays finite.
pub(super) fn nearest(number: f64) -> f32 {
    if number.is_finite() {
        number.clamp(f32::MIN.into(), f32::MAX.into()) as f32
    } else {
        number as f32
    }
}

/// The samples as a header describes them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) dims: [usize; 3],
    pub(super) stored: SampleType,
    pub(super) endian: Endian,
}

/// The number of bytes that are converted at a time. It is a multiple of every type's size.
const PIECE: usize = 1 << 16;

impl Layout {
    /// The number of samples. `dims` was checked, so that this number and the number of bytes stay in range.
    pub(super) fn count(&self) -> usize {
        self.dims.iter().product()
    }

    /// The number of bytes of all samples.
    pub(super) fn bytes(&self) -> usize {
        self.count() * self.stored.size()
    }

    /// Checks that there are at least as many bytes as the samples take.
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

    /// Appends the samples, or as many as there are. Returns the number of bytes that were read. No more is unpacked
    /// than the samples take, and nothing but the samples is kept.
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

/// Fills the buffer as far as bytes are left. Only at the end of the source are they fewer than the buffer's length.
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

/// Makes room for exactly so many more samples, in one step. Callers know that the file's bytes can hold as many; a
/// header's promise is not enough.
pub(super) fn make_room(samples: &mut Vec<f32>, count: usize) -> Result<(), Fault> {
    samples.try_reserve_exact(count).map_err(|_| {
        let size = (count * size_of::<f32>()) >> 20;
        (
            format!("{count} samples take {size} MiB of memory, and the system does not give them"),
            "Crop it or take every other sample.",
        )
    })
}

/// A number as people and programs write it. It may be `nan`, `-inf`, `1.#INF`, `-1.#IND` or `nan(ind)`, which C
/// libraries print.
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
