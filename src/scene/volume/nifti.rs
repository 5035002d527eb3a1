//! NIfTI-1 in one file, plain (`.nii`) or packed (`.nii.gz`).
//!
//! The `nifti` crate reads the header. The samples are read here: the crate would allocate what the header promises
//! before it looks at what is there. Stored values are scaled as the header asks; the samples stand where its sform
//! says, or else its qform, or else its voxel sizes.

use std::path::Path;

use ::nifti::{Endianness, NiftiHeader, NiftiType};
use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::check;
use super::gzip;
use super::load::{Layout, Loaded, finish};
use super::samples::{Endian, SampleType};
use crate::error::{Error, Place, Result};

/// Bytes of the header, without extensions.
const HEADER: usize = 348;

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Loaded> {
    let packed = bytes.starts_with(&[0x1f, 0x8b]);
    let damaged = |error: String| {
        let remedy = "The file is damaged or cut off: get it again.";
        let what = format!("it does not unpack: {error}");
        Error::input(Place::file(path), what, remedy)
    };
    let head = if packed {
        gzip::unpack(bytes, HEADER).map_err(damaged)?
    } else {
        bytes[..bytes.len().min(HEADER)].to_vec()
    };
    let header = header(path, &head)?;
    let layout = layout(path, &header)?;
    let start = start(path, &header)?;
    let wanted = start + layout.bytes();
    let short = |found: usize| {
        let fault = layout.expect(found.saturating_sub(start));
        fault.map_err(|(what, remedy)| wrong(path, "dim", what, remedy))
    };
    let unpacked;
    let bytes = if packed {
        if !gzip::can_hold(bytes.len(), wanted as u64) {
            short(0)?;
        }
        unpacked = gzip::unpack(bytes, wanted).map_err(damaged)?;
        &unpacked
    } else {
        bytes
    };
    short(bytes.len())?;
    let mut samples = layout.stored.convert(&bytes[start..wanted], layout.endian);
    scale(&header, &mut samples);
    let (field, affine) = placement(&header);
    let places = ["datatype", field].map(|field| Place::file(path).token(field));
    let volume = finish(path, layout.dims, samples, affine, places)?;
    Ok(Loaded {
        volume,
        notices: Vec::new(),
    })
}

/// Something is wrong with a field of the header.
fn wrong(path: &Path, field: &str, what: impl Into<String>, remedy: &str) -> Error {
    Error::input(Place::file(path).token(field), what, remedy)
}

fn header(path: &Path, head: &[u8]) -> Result<NiftiHeader> {
    let unusable = |field: &str, what: String| {
        let remedy = "Give a NIfTI-1 file with header and samples in one (.nii or .nii.gz).";
        wrong(path, field, what, remedy)
    };
    if head.len() < HEADER {
        let what = format!(
            "a NIfTI-1 header has {HEADER} bytes, here are {}",
            head.len()
        );
        return Err(unusable("sizeof_hdr", what));
    }
    let header = NiftiHeader::from_reader(head)
        .map_err(|error| unusable("magic", format!("this is not a NIfTI-1 header: {error}")))?;
    if header.sizeof_hdr != HEADER as i32 {
        return Err(unusable(
            "sizeof_hdr",
            format!("it is {}", header.sizeof_hdr),
        ));
    }
    if &header.magic != b"n+1\0" {
        return Err(unusable("magic", "its samples are in another file".into()));
    }
    Ok(header)
}

fn layout(path: &Path, header: &NiftiHeader) -> Result<Layout> {
    let [count, x, y, z, rest @ ..] = header.dim.map(usize::from);
    let further = &rest[..count.clamp(3, 7) - 3];
    if !(3..=7).contains(&count) || further.iter().any(|&length| length != 1) {
        let what = format!("the dimensions are {:?}", &header.dim[..=count.min(7)]);
        let remedy = "Give a single three-dimensional volume.";
        return Err(wrong(path, "dim", what, remedy));
    }
    let dims = [x, y, z];
    check::dims(dims).map_err(|(what, remedy)| wrong(path, "dim", what, remedy))?;
    let stored = header.data_type().ok().and_then(stored).ok_or_else(|| {
        let what = format!("the samples are of type {}", header.datatype);
        let remedy = "Known are the integers of 8 to 64 bits and the floats of 32 and 64.";
        wrong(path, "datatype", what, remedy)
    })?;
    let endian = match header.endianness {
        Endianness::Little => Endian::Little,
        Endianness::Big => Endian::Big,
    };
    Ok(Layout {
        dims,
        stored,
        endian,
    })
}

fn stored(kind: NiftiType) -> Option<SampleType> {
    Some(match kind {
        NiftiType::Int8 => SampleType::I8,
        NiftiType::Uint8 => SampleType::U8,
        NiftiType::Int16 => SampleType::I16,
        NiftiType::Uint16 => SampleType::U16,
        NiftiType::Int32 => SampleType::I32,
        NiftiType::Uint32 => SampleType::U32,
        NiftiType::Int64 => SampleType::I64,
        NiftiType::Uint64 => SampleType::U64,
        NiftiType::Float32 => SampleType::F32,
        NiftiType::Float64 => SampleType::F64,
        _ => return None,
    })
}

/// Where the samples begin. Beyond 2^24 not every f32 is a byte's place, and no header is that long.
fn start(path: &Path, header: &NiftiHeader) -> Result<usize> {
    let offset = header.vox_offset;
    if (HEADER as f32..16_777_216.0).contains(&offset) && offset.fract() == 0.0 {
        return Ok(offset as usize);
    }
    let what = format!("the samples begin at byte {offset}");
    let remedy = "Give a whole number from 352; the header may be damaged.";
    Err(wrong(path, "vox_offset", what, remedy))
}

/// A slope of 0 means that there is nothing to scale.
fn scale(header: &NiftiHeader, samples: &mut [f32]) {
    let [slope, inter] = [header.scl_slope, header.scl_inter].map(f64::from);
    if slope == 0.0 || (slope == 1.0 && inter == 0.0) {
        return;
    }
    for sample in samples {
        *sample = (f64::from(*sample) * slope + inter) as f32;
    }
}

/// The field that places the samples, and where it does.
fn placement(header: &NiftiHeader) -> (&'static str, DAffine3) {
    let [qfac, dx, dy, dz, ..] = header.pixdim.map(f64::from);
    let sizes = DVec3::new(dx, dy, dz);
    if header.sform_code > 0 {
        let rows = [header.srow_x, header.srow_y, header.srow_z].map(|row| row.map(f64::from));
        let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
        let axes = DMat3::from_cols(column(0), column(1), column(2));
        return ("srow", DAffine3::from_mat3_translation(axes, column(3)));
    }
    if header.qform_code > 0 {
        let imaginary = DVec3::new(
            header.quatern_b.into(),
            header.quatern_c.into(),
            header.quatern_d.into(),
        );
        // The real part is left out of the file; rounding may have made the rest a little longer than 1.
        let real = (1.0 - imaginary.length_squared()).max(0.0).sqrt();
        let rotation = DQuat::from_xyzw(imaginary.x, imaginary.y, imaginary.z, real);
        let handed = if qfac < 0.0 { -1.0 } else { 1.0 };
        let axes = matrix(rotation) * DMat3::from_diagonal(sizes * DVec3::new(1.0, 1.0, handed));
        let origin = DVec3::new(
            header.quatern_x.into(),
            header.quatern_y.into(),
            header.quatern_z.into(),
        );
        return ("pixdim", DAffine3::from_mat3_translation(axes, origin));
    }
    ("pixdim", DAffine3::from_scale(sizes))
}

/// A quaternion of any length but zero; what is not finite stays so, to be refused with the placement.
fn matrix(rotation: DQuat) -> DMat3 {
    DMat3::from_quat(rotation.normalize())
}
