//! Bytes of a file become samples.

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

    /// Converts whole samples to the nearest f32. 8 and 16 bits are exact; those with more are rounded.
    pub(super) fn convert(self, bytes: &[u8], endian: Endian) -> Vec<f32> {
        macro_rules! read {
            ($type:ty) => {
                read(bytes, |sample| match endian {
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
            Self::F64 => read!(f64),
        }
    }
}

fn read<const N: usize>(bytes: &[u8], convert: impl Fn([u8; N]) -> f32) -> Vec<f32> {
    let (samples, _) = bytes.as_chunks();
    samples.iter().map(|&sample| convert(sample)).collect()
}
