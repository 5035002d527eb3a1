//! NIfTI-1 and NIfTI-2 in one file, plain (`.nii`) or packed (`.nii.gz`).
//!
//! Stored values are scaled as the header asks. A slope that is 0 or not finite means no scaling, and an intercept that
//! is not finite means 0. The samples are placed by the sform, or else by the qform, or else by the voxel sizes. Axes
//! are the patient's right-anterior-superior ones, which are the world's.

mod header;

use std::io::Read;
use std::path::Path;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::check;
use super::gzip;
use super::reading::{Loaded, Parts, Stored, Wish};
use super::samples::{Layout, SampleType, make_room, nearest};
use crate::error::{Error, Place, Result};
use header::Header;

pub(super) fn read(path: &Path, bytes: &[u8], wish: &Wish) -> Result<Loaded> {
    let packed = gzip::is_gzip(bytes);
    let header = if packed {
        let mut head = Vec::new();
        let mut unpacker = gzip::unpack(bytes).take(header::LONGEST as u64);
        let read = unpacker.read_to_end(&mut head);
        read.map_err(|error| damaged(path, &error))?;
        Header::read(path, &head)?
    } else {
        Header::read(path, bytes)?
    };
    let layout = layout(path, &header)?;
    let place = Place::file(path).token("dim");
    wish.expect_room(layout.count(), Stored::of(bytes), place)?;
    let mut samples = if packed {
        unpack(path, bytes, &header, &layout)?
    } else {
        let start = start(path, &header)?;
        let data = bytes.get(start..).unwrap_or_default();
        expect(path, &layout, data.len())?;
        let mut samples = room(path, &layout)?;
        let read = layout.read(data, &mut samples);
        read.map_err(|error| damaged(path, &error))?;
        samples
    };
    let notices = scale(path, &header, &mut samples);
    let (field, index_to_world) = placement(&header);
    Parts {
        path,
        dims: layout.dims,
        samples,
        index_to_world,
        placed_by: Place::file(path).token(field),
        notices: notices.into_iter().collect(),
    }
    .finish(wish)
}

fn unpack(path: &Path, bytes: &[u8], header: &Header, layout: &Layout) -> Result<Vec<f32>> {
    let start = start(path, header)?;
    let wanted = start as u64 + layout.bytes() as u64;
    if !gzip::can_hold(bytes.len() as u64, wanted) {
        expect(path, layout, 0)?;
    }
    let mut unpacker = gzip::unpack(bytes);
    let mut samples = room(path, layout)?;
    let skipped = std::io::copy(
        &mut unpacker.by_ref().take(start as u64),
        &mut std::io::sink(),
    );
    let read = skipped.and_then(|_| layout.read(unpacker, &mut samples));
    expect(path, layout, read.map_err(|error| damaged(path, &error))?)?;
    Ok(samples)
}

fn room(path: &Path, layout: &Layout) -> Result<Vec<f32>> {
    let mut samples = Vec::new();
    make_room(&mut samples, layout.count()).map_err(|fault| too_large(path, fault))?;
    Ok(samples)
}

/// The error for a field of the header.
fn wrong(path: &Path, field: &str, what: impl Into<String>, remedy: &str) -> Error {
    Error::input(Place::file(path).token(field), what, remedy)
}

fn damaged(path: &Path, error: &std::io::Error) -> Error {
    let remedy = "The file is damaged or cut off: get it again.";
    let what = format!("it does not unpack: {error}");
    Error::input(Place::file(path), what, remedy)
}

fn too_large(path: &Path, (what, remedy): check::Fault) -> Error {
    wrong(path, "dim", what, remedy)
}

fn expect(path: &Path, layout: &Layout, found: usize) -> Result<()> {
    layout
        .expect(found)
        .map_err(|(what, remedy)| wrong(path, "dim", what, remedy))
}

fn layout(path: &Path, header: &Header) -> Result<Layout> {
    let [count, x, y, z, rest @ ..] = header.dim;
    let used = usize::try_from(count)
        .ok()
        .filter(|used| (3..=7).contains(used));
    let single = used.is_some_and(|used| rest[..used - 3].iter().all(|&length| length == 1));
    if !single {
        let shown = usize::try_from(count).unwrap_or(0).min(7);
        let what = format!("the dimensions are {:?}", &header.dim[..=shown]);
        let remedy = "Give a single three-dimensional volume.";
        return Err(wrong(path, "dim", what, remedy));
    }
    let dims = [x, y, z].map(|length| usize::try_from(length).unwrap_or(0));
    check::dims(dims).map_err(|fault| too_large(path, fault))?;
    let stored = stored(header.datatype).map_err(|name| {
        let what = format!(
            "the samples of this {} file are of type {}{name}",
            header.name(),
            header.datatype
        );
        let remedy = "Known are the integers of 8 to 64 bits and the floats of 32 and 64.";
        wrong(path, "datatype", what, remedy)
    })?;
    Ok(Layout {
        dims,
        stored,
        endian: header.endian,
    })
}

/// The type, or the standard's name for a type that cannot be read.
fn stored(datatype: i16) -> Result<SampleType, &'static str> {
    Ok(match datatype {
        2 => SampleType::U8,
        4 => SampleType::I16,
        8 => SampleType::I32,
        16 => SampleType::F32,
        64 => SampleType::F64,
        256 => SampleType::I8,
        512 => SampleType::U16,
        768 => SampleType::U32,
        1024 => SampleType::I64,
        1280 => SampleType::U64,
        1 => return Err(", BINARY (single bits)"),
        32 => return Err(", COMPLEX64"),
        128 => return Err(", RGB24"),
        1536 => return Err(", FLOAT128"),
        1792 => return Err(", COMPLEX128"),
        2048 => return Err(", COMPLEX256"),
        2304 => return Err(", RGBA32"),
        _ => return Err(", which the standard does not know"),
    })
}

/// The offset of the samples. Beyond 2^24 an f32 cannot be every offset, and no header is that long.
fn start(path: &Path, header: &Header) -> Result<usize> {
    let offset = header.offset;
    let first = header.size();
    if (first as f64..16_777_216.0).contains(&offset) && offset.fract() == 0.0 {
        return Ok(offset as usize);
    }
    let what = format!("the samples begin at byte {offset}");
    let least = first + 4;
    let remedy = format!("Give a whole number from {least}; the header may be damaged.");
    Err(wrong(path, "vox_offset", what, &remedy))
}

/// Scales the samples. Returns a sentence if the header's numbers are wrong.
fn scale(path: &Path, header: &Header, samples: &mut [f32]) -> Option<String> {
    let Header { slope, inter, .. } = *header;
    let is_scaled = slope.is_finite() && slope != 0.0;
    let shift = if inter.is_finite() { inter } else { 0.0 };
    if is_scaled && (slope, shift) != (1.0, 0.0) {
        for sample in samples {
            *sample = nearest_scaled(*sample, slope, shift);
        }
    }
    let name = path.display();
    if !slope.is_finite() {
        return Some(format!(
            "{name}: `scl_slope` is {slope}, so that the stored values are taken as they are"
        ));
    }
    (is_scaled && !inter.is_finite())
        .then(|| format!("{name}: `scl_inter` is {inter}, and is taken as 0"))
}

/// The scaled sample. What is not a number is not one after scaling, and a finite number stays finite.
fn nearest_scaled(sample: f32, slope: f64, inter: f64) -> f32 {
    if sample.is_finite() {
        nearest((f64::from(sample) * slope + inter).clamp(f64::MIN, f64::MAX))
    } else {
        sample
    }
}

/// The field that places the samples, and the placement.
fn placement(header: &Header) -> (&'static str, DAffine3) {
    let [qfac, dx, dy, dz] = header.pixdim;
    let sizes = DVec3::new(dx, dy, dz);
    if header.sform > 0 {
        let column = |i: usize| DVec3::from_array(header.srow.map(|row| row[i]));
        let axes = DMat3::from_cols(column(0), column(1), column(2));
        return ("srow", DAffine3::from_mat3_translation(axes, column(3)));
    }
    if header.qform > 0 {
        let imaginary = DVec3::from_array(header.quatern);
        // The file leaves out the real part. Rounding may have made the rest a little longer than 1.
        let real = (1.0 - imaginary.length_squared()).max(0.0).sqrt();
        let rotation = DQuat::from_xyzw(imaginary.x, imaginary.y, imaginary.z, real);
        let handed = if qfac < 0.0 { -1.0 } else { 1.0 };
        let axes = matrix(rotation) * DMat3::from_diagonal(sizes * DVec3::new(1.0, 1.0, handed));
        let origin = DVec3::from_array(header.origin);
        return ("pixdim", DAffine3::from_mat3_translation(axes, origin));
    }
    ("pixdim", DAffine3::from_scale(sizes))
}

/// The rotation of a quaternion of any length but zero. Numbers that are not finite stay so, and the placement is
/// refused later.
fn matrix(rotation: DQuat) -> DMat3 {
    DMat3::from_quat(rotation.normalize())
}
