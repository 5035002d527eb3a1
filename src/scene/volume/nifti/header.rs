//! The header of both versions. They have the same fields at different offsets and with different widths.
//!
//! Source: the standards' nifti1.h and nifti2.h, <https://nifti.nimh.nih.gov>. The crate that reads NIfTI knows only
//! the first version, so the header is read here.

use std::path::Path;

use crate::error::{Error, Place, Result};
use crate::scene::volume::samples::Endian;

/// The fields of a header that are used, with all numbers widened.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) endian: Endian,
    /// The number of dimensions that are used, then the length of each.
    pub(super) dim: [i64; 8],
    pub(super) datatype: i16,
    /// The sign of z, then the voxel's sizes.
    pub(super) pixdim: [f64; 4],
    /// The offset of the samples, in bytes.
    pub(super) offset: f64,
    pub(super) slope: f64,
    pub(super) inter: f64,
    pub(super) qform: i64,
    pub(super) sform: i64,
    /// b, c and d.
    pub(super) quatern: [f64; 3],
    pub(super) origin: [f64; 3],
    pub(super) srow: [[f64; 4]; 3],
    version: &'static Version,
}

/// The offsets of the fields.
#[derive(Debug)]
struct Version {
    name: &'static str,
    /// The number of bytes of a header.
    size: usize,
    magic: usize,
    /// The magic of a file that holds header and samples.
    single: &'static [u8],
    /// The magic of a header whose samples are in another file.
    pair: &'static [u8],
    dim: usize,
    datatype: usize,
    pixdim: usize,
    offset: usize,
    slope: usize,
    codes: usize,
    quatern: usize,
    srow: usize,
    is_wide: bool,
}

static ONE: Version = Version {
    name: "NIfTI-1",
    size: 348,
    magic: 344,
    single: b"n+1\0",
    pair: b"ni1\0",
    dim: 40,
    datatype: 70,
    pixdim: 76,
    offset: 108,
    slope: 112,
    codes: 252,
    quatern: 256,
    srow: 280,
    is_wide: false,
};

static TWO: Version = Version {
    name: "NIfTI-2",
    size: 540,
    magic: 4,
    single: b"n+2\0\r\n\x1a\n",
    pair: b"ni2\0\r\n\x1a\n",
    dim: 16,
    datatype: 12,
    pixdim: 104,
    offset: 168,
    slope: 176,
    codes: 344,
    quatern: 352,
    srow: 400,
    is_wide: true,
};

/// The number of bytes of the longer header.
pub(super) const LONGEST: usize = 540;

const REMEDY: &str =
    "Give a NIfTI-1 or NIfTI-2 file with header and samples in one (.nii or .nii.gz).";

impl Header {
    pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Self> {
        let unusable =
            |field: &str, what: String| Error::input(Place::file(path).token(field), what, REMEDY);
        let (version, endian) = recognise(bytes).map_err(|what| unusable("sizeof_hdr", what))?;
        if bytes.len() < version.size {
            let (name, size, found) = (version.name, version.size, bytes.len());
            let what = format!("a {name} header has {size} bytes, here are {found}");
            return Err(unusable("sizeof_hdr", what));
        }
        let magic = &bytes[version.magic..][..version.single.len()];
        if magic == version.pair {
            let what = format!(
                "this is the header of a {} pair (.hdr and .img): its samples are in another file",
                version.name
            );
            return Err(unusable("magic", what));
        }
        if magic != version.single {
            let shown = magic.escape_ascii();
            let what = match version.size {
                348 => format!("'{shown}' is not NIfTI-1's; without it this may be ANALYZE 7.5"),
                _ => format!("'{shown}' is not {}'s", version.name),
            };
            return Err(unusable("magic", what));
        }
        Ok(Fields {
            bytes,
            endian,
            version,
        }
        .header())
    }

    /// The version's name.
    pub(super) fn name(&self) -> &'static str {
        self.version.name
    }

    /// The number of bytes of the header alone.
    pub(super) fn size(&self) -> usize {
        self.version.size
    }
}

/// The version and the byte order, by the header's first field: its own size, which is one of two numbers in one of two
/// byte orders.
fn recognise(bytes: &[u8]) -> Result<(&'static Version, Endian), String> {
    let Some(first) = bytes.first_chunk() else {
        return Err(format!("there are {} bytes", bytes.len()));
    };
    for version in [&ONE, &TWO] {
        let size = version.size as i32;
        if i32::from_le_bytes(*first) == size {
            return Ok((version, Endian::Little));
        }
        if i32::from_be_bytes(*first) == size {
            return Ok((version, Endian::Big));
        }
    }
    let found = i32::from_le_bytes(*first);
    Err(format!(
        "it is {found}, where a NIfTI-1 header has 348 and a NIfTI-2 header 540"
    ))
}

struct Fields<'a> {
    bytes: &'a [u8],
    endian: Endian,
    version: &'static Version,
}

macro_rules! number {
    ($fields:expr, $at:expr, $type:ty) => {{
        let bytes = $fields.bytes[$at..].first_chunk();
        let bytes = *bytes.expect("the header's length was checked");
        match $fields.endian {
            Endian::Little => <$type>::from_le_bytes(bytes),
            Endian::Big => <$type>::from_be_bytes(bytes),
        }
    }};
}

impl Fields<'_> {
    fn header(&self) -> Header {
        let at = self.version;
        let slope = self.floats(at.slope);
        let codes = self.codes();
        let quatern: [f64; 6] = self.floats(at.quatern);
        let [b, c, d, origin @ ..] = quatern;
        let rows: [f64; 12] = self.floats(at.srow);
        let [slope, inter] = slope;
        Header {
            endian: self.endian,
            dim: std::array::from_fn(|i| self.length(i)),
            datatype: number!(self, at.datatype, i16),
            pixdim: self.floats(at.pixdim),
            offset: self.offset(),
            slope,
            inter,
            qform: codes[0],
            sform: codes[1],
            quatern: [b, c, d],
            origin,
            srow: std::array::from_fn(|row| std::array::from_fn(|i| rows[4 * row + i])),
            version: at,
        }
    }

    /// The first version does not allow lengths beyond 32767. They are read as unsigned.
    fn length(&self, i: usize) -> i64 {
        if self.version.is_wide {
            number!(self, self.version.dim + 8 * i, i64)
        } else {
            number!(self, self.version.dim + 2 * i, u16).into()
        }
    }

    fn codes(&self) -> [i64; 2] {
        std::array::from_fn(|i| {
            if self.version.is_wide {
                number!(self, self.version.codes + 4 * i, i32).into()
            } else {
                number!(self, self.version.codes + 2 * i, i16).into()
            }
        })
    }

    fn offset(&self) -> f64 {
        if self.version.is_wide {
            number!(self, self.version.offset, i64) as f64
        } else {
            number!(self, self.version.offset, f32).into()
        }
    }

    fn floats<const N: usize>(&self, at: usize) -> [f64; N] {
        std::array::from_fn(|i| {
            if self.version.is_wide {
                number!(self, at + 8 * i, f64)
            } else {
                number!(self, at + 4 * i, f32).into()
            }
        })
    }
}
