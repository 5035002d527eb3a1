//! Volumes: samples on a lattice, anywhere in world space.
//!
//! The samples are points, not cells. The lattice of `dims` points fills the parallelepiped from the first sample to
//! the last one along each axis. This is the volume's *proxy box*; there is nothing outside of it. Between the samples,
//! values are interpolated trilinearly. A volume that was read from a file stands where the file says, and its
//! [`Transform`] is applied to that.
//!
//! A sample may be *empty* (NaN): nothing was measured or computed there. A cell is the box between eight neighbouring
//! samples. If one of its corners is empty, the cell is empty: it has no value and no density, and no isosurface goes
//! through it. An empty sample is not replaced by any value, because all values between that value and the neighbouring
//! ones would appear, and with them shells that are not in the data.

mod check;
#[cfg(feature = "formats")]
mod gzip;
#[cfg(feature = "formats")]
mod load;
mod missing;
#[cfg(feature = "formats")]
mod nifti;
#[cfg(feature = "formats")]
mod nrrd;
#[cfg(feature = "formats")]
mod reading;
#[cfg(feature = "formats")]
mod samples;
#[cfg(feature = "formats")]
mod space;
mod transfer;
#[cfg(feature = "formats")]
mod vti;

use glam::{DAffine3, DVec3};

pub use check::MAX_SAMPLES;
#[cfg(feature = "formats")]
pub(super) use load::load;
#[cfg(feature = "formats")]
pub(super) use missing::Missing;
#[cfg(feature = "formats")]
pub(super) use reading::Wish;
pub(super) use transfer::fault;
pub use transfer::{Medium, Transfer, TransferPoint};

use super::bounds::Bounds;
use super::transform::Transform;
use crate::error::{Error, Result};

/// Samples on a lattice, with their placement and their look.
#[derive(Clone, Debug)]
pub struct Volume {
    /// Name, for messages: the file's stem or the generator's name.
    pub name: String,
    /// The colours and densities of the stored values.
    pub transfer: Transfer,
    /// The sampling distance along a ray in voxels, greater than 0. See [`Volume::sampling_distance`].
    pub step: f64,
    has_empty: bool,
    dims: [usize; 3],
    samples: Vec<f32>,
    index_to_world: DAffine3,
    world_to_index: DAffine3,
}

impl Volume {
    /// The default sampling distance, in voxels.
    pub const DEFAULT_STEP: f64 = 0.5;

    /// A volume of `dims` samples, x fastest, with the sample (i, j, k) at `index_to_world` (i, j, k). A NaN is an
    /// empty sample.
    ///
    /// # Errors
    /// An axis has fewer than 2 samples. There are more than [`MAX_SAMPLES`] samples, or not as many as `dims` says. A
    /// sample is infinite or beyond 1e38. The placement is flat or not finite.
    pub fn new(
        name: impl Into<String>,
        dims: [usize; 3],
        samples: Vec<f32>,
        index_to_world: DAffine3,
    ) -> Result<Self> {
        let name = name.into();
        let fault = check::dims(dims)
            .err()
            .or_else(|| check::count(dims, samples.len()).err())
            .or_else(|| check::samples(&samples).err())
            .or_else(|| check::placement(&index_to_world).err());
        if let Some((what, remedy)) = fault {
            return Err(Error::scene(format!("the volume '{name}': {what}"), remedy));
        }
        Ok(Self {
            name,
            transfer: Transfer::default(),
            step: Self::DEFAULT_STEP,
            has_empty: samples.iter().any(|sample| sample.is_nan()),
            dims,
            samples,
            index_to_world,
            world_to_index: index_to_world.inverse(),
        })
    }

    /// The number of samples along each axis, 2 or more.
    pub fn dims(&self) -> [usize; 3] {
        self.dims
    }

    /// The samples, x fastest, from -1e38 to 1e38, or NaN if empty.
    pub fn samples(&self) -> &[f32] {
        &self.samples
    }

    /// Whether a sample is empty.
    pub fn has_empty(&self) -> bool {
        self.has_empty
    }

    /// The map from a sample's indices to its place in the world.
    pub fn index_to_world(&self) -> DAffine3 {
        self.index_to_world
    }

    /// The map from the world to indices, which are whole numbers at the samples.
    pub fn world_to_index(&self) -> DAffine3 {
        self.world_to_index
    }

    /// The value at a world point. It is `None` outside of the proxy box, and NaN in an empty cell.
    pub fn at(&self, world: DVec3) -> Option<f64> {
        let index = self.world_to_index.transform_point3(world);
        let inside = index.cmpge(DVec3::ZERO).all() && index.cmple(self.last()).all();
        inside.then(|| self.at_index(index))
    }

    /// The value at a point given in indices, which need not be whole. A point outside is moved to the proxy box's
    /// surface. The value is NaN in an empty cell.
    pub fn at_index(&self, index: DVec3) -> f64 {
        let index = index.clamp(DVec3::ZERO, self.last());
        let [nx, ny, _] = self.dims;
        // The cell that the point is in, or the last cell for a point at the very end.
        let cell: [usize; 3] =
            std::array::from_fn(|axis| (index[axis] as usize).min(self.dims[axis] - 2));
        let [x, y, z]: [f64; 3] = std::array::from_fn(|axis| index[axis] - cell[axis] as f64);
        let first = cell[0] + nx * (cell[1] + ny * cell[2]);
        // A NaN makes the result NaN, whatever its weight.
        let mix = |from: f64, to: f64, part: f64| from + (to - from) * part;
        let along_x = |row: usize| {
            let [from, to] = [self.samples[row], self.samples[row + 1]].map(f64::from);
            mix(from, to, x)
        };
        let along_y = |slice: usize| mix(along_x(slice), along_x(slice + nx), y);
        mix(along_y(first), along_y(first + nx * ny), z)
    }

    /// The indices of the last sample.
    pub fn last(&self) -> DVec3 {
        DVec3::from_array(self.dims.map(|count| (count - 1) as f64))
    }

    /// The proxy box's corners in the world. Bits 0, 1 and 2 of a corner's number say whether it is at the end of x, y
    /// and z.
    pub fn corners(&self) -> [DVec3; 8] {
        let index = Bounds {
            min: DVec3::ZERO,
            max: self.last(),
        };
        index
            .corners()
            .map(|corner| self.index_to_world.transform_point3(corner))
    }

    /// The axis-aligned box around the corners.
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.corners()).expect("there are eight corners")
    }

    /// The smallest distance between neighbouring samples along an axis, in world units.
    pub fn voxel(&self) -> f64 {
        let axes = self.index_to_world.matrix3;
        let lengths = [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::length);
        lengths.into_iter().fold(f64::INFINITY, f64::min)
    }

    /// [`Volume::step`] in world units. Where several volumes overlap, a ray takes the smallest of their distances.
    pub fn sampling_distance(&self) -> f64 {
        self.step * self.voxel()
    }

    /// The same volume with another transfer function.
    #[must_use]
    pub fn with_transfer(mut self, transfer: Transfer) -> Self {
        self.transfer = transfer;
        self
    }

    /// The transformed volume.
    ///
    /// # Errors
    /// The transform takes the volume out of the range of numbers, or makes it flat.
    pub fn transformed(mut self, transform: &Transform) -> Result<Self> {
        let moved = transform.to_affine() * self.index_to_world;
        if let Err((what, remedy)) = check::placement(&moved) {
            let what = format!("the volume '{}', transformed: {what}", self.name);
            return Err(Error::scene(what, remedy));
        }
        self.index_to_world = moved;
        self.world_to_index = moved.inverse();
        Ok(self)
    }
}
