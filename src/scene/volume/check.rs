//! Checks that every volume must pass, from a file or from code. A failure says what is wrong and what to do.

use glam::DAffine3;

/// The most samples of a volume: 512 Mi, which take 2 GiB.
pub const MAX_SAMPLES: u64 = 512 << 20;

/// The largest absolute value of a sample. Larger values have no use, and their differences would exceed the 32-bit
/// numbers of shaders.
pub(super) const LARGEST: f32 = 1e38;

/// The value of an empty sample.
pub(super) const EMPTY: f32 = f32::NAN;

/// A fault: what is wrong, and what to do.
pub(super) type Fault = (String, &'static str);

/// The number of samples. Each axis needs at least two, or there would be no space between them.
pub(super) fn dims(dims: [usize; 3]) -> Result<usize, Fault> {
    if let Some(short) = dims.iter().find(|&&count| count < 2) {
        return Err((
            format!("{short} samples along an axis of {}", shown(dims)),
            "Give a volume with at least 2 samples along each axis.",
        ));
    }
    count_of(dims)
}

/// The number of samples, unless there are too many.
pub(super) fn count_of(dims: [usize; 3]) -> Result<usize, Fault> {
    let count = dims.into_iter().try_fold(1_u64, |product, count| {
        product.checked_mul(u64::try_from(count).ok()?)
    });
    match count {
        Some(count) if count <= MAX_SAMPLES => Ok(count as usize),
        _ => Err((
            format!(
                "{} are more than {MAX_SAMPLES} samples, the most that are read",
                shown(dims)
            ),
            "Crop it or take every other sample.",
        )),
    }
}

/// Checks that there are as many samples as `dims` says.
pub(super) fn count(dims: [usize; 3], found: usize) -> Result<(), Fault> {
    if dims.iter().product::<usize>() == found {
        return Ok(());
    }
    Err((
        format!("{} samples for {}", found, shown(dims)),
        "Give x times y times z samples.",
    ))
}

/// Checks every sample. NaN is allowed and means empty. A number that is too large would take results out of range.
pub(super) fn samples(samples: &[f32]) -> Result<(), Fault> {
    match samples.iter().position(|sample| sample.abs() > LARGEST) {
        None => Ok(()),
        Some(place) => Err((
            format!("its sample number {place} is {:e}", samples[place]),
            "Give samples from -1e38 to 1e38, or NaN for one that is empty.",
        )),
    }
}

/// Lengths beyond these are mistakes, and would take products out of range.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-12..=1e12;

/// The largest allowed ratio of a voxel's length to its width.
const LONGEST_VOXEL: f64 = 1e3;

/// Checks that the axes have sensible lengths and span a volume.
pub(super) fn placement(index_to_world: &DAffine3) -> Result<(), Fault> {
    let axes = index_to_world.matrix3;
    let lengths = [axes.x_axis, axes.y_axis, axes.z_axis].map(glam::DVec3::length);
    if let Some(length) = lengths.into_iter().find(|length| !LENGTHS.contains(length)) {
        return Err((
            format!("neighbouring samples are {length} apart"),
            "Give finite spacings of a size from 1e-12 to 1e12.",
        ));
    }
    if !(0.0..=*LENGTHS.end()).contains(&index_to_world.translation.length()) {
        return Err((
            format!("its first sample is at {}", index_to_world.translation),
            "Give finite coordinates of at most 1e12.",
        ));
    }
    // Otherwise a ray could have many more samples than the volume's size suggests.
    let [shortest, longest] =
        [f64::min, f64::max].map(|pick| lengths.into_iter().reduce(pick).unwrap_or(1.0));
    if longest > LONGEST_VOXEL * shortest {
        return Err((
            format!("its voxels are {longest} long and {shortest} wide"),
            "Give spacings of similar sizes, at most 1 to 1000.",
        ));
    }
    // The limit is relative to a cuboid of the same lengths, so that thin volumes are allowed.
    let fullness = axes.determinant().abs() / lengths.into_iter().product::<f64>();
    if !(1e-6..).contains(&fullness) {
        return Err((
            "its axes lie in one plane".into(),
            "Give three directions that span a body.",
        ));
    }
    Ok(())
}

fn shown([x, y, z]: [usize; 3]) -> String {
    format!("{x} x {y} x {z}")
}
