//! Volumes made by rule: scalar fields, sampled on a lattice.
//!
//! Each field fills a cube around the origin. In a scene file the parameters are keys of the same names, next to
//! `generate = "ball"` in a `[[volume]]`. The transfer function of the `[[volume]]` gives the values their look.

mod ball;
mod constant;
mod ejection;
mod gradient;
mod potential;
mod shepp_logan;
mod swirl;

pub use ball::{Ball, ball};
pub use constant::{Constant, constant};
pub use ejection::{Ejection, EjectionPart, ejection};
pub use gradient::{Gradient, gradient};
pub use potential::{Atom, Potential, potential};
pub use shepp_logan::{SheppLogan, shepp_logan};
pub use swirl::{Swirl, swirl};

use glam::{DAffine3, DVec3};

use super::Refusal;
use super::limits::{LENGTH, count_within, within};
use crate::error::{Error, Result};
use crate::memory::MemoryLimit;
use crate::scene::volume::Volume;

/// The cube that a field fills, and the number of its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// The edge of the cube, 1e-6 to 1e6. The cube is centred at the origin.
    pub size: f32,
    /// The number of samples along each edge, 2 to 512. The first and the last sample lie on the cube's faces.
    pub samples: u32,
}

impl Lattice {
    /// A cube from -1 to 1.
    pub const fn of(samples: u32) -> Self {
        Self { size: 2.0, samples }
    }

    fn check(&self) -> Result<(), Refusal> {
        within("size", self.size, LENGTH)?;
        count_within("samples", self.samples, [2, 512])
    }
}

/// The functions that every field has.
pub(in crate::low_level::scene) trait Field {
    /// Checks that every parameter is in its range. The lattice's parameters are checked elsewhere.
    fn check(&self) -> Result<(), Refusal>;

    /// The lattice on which it is sampled.
    fn lattice(&self) -> Lattice;

    /// The field's name in scene files.
    fn name(&self) -> &'static str;

    /// The field's value at a point. The parameters must be in their ranges.
    fn value(&self, point: DVec3) -> f64;
}

/// The memory that a field's samples take, in bytes, or an error if a parameter is out of its range.
pub(in crate::low_level::scene) fn bytes(field: &dyn Field) -> Result<u64, Refusal> {
    field.lattice().check()?;
    field.check()?;
    let samples = u64::from(field.lattice().samples).pow(3);
    Ok(samples * size_of::<f32>() as u64)
}

/// The sampled field, or an error if a parameter is out of its range.
pub(in crate::low_level::scene) fn sampled(field: &dyn Field) -> Result<Volume, Refusal> {
    let room = bytes(field)? as usize / size_of::<f32>();
    let Lattice { size, samples } = field.lattice();
    let spacing = f64::from(size) / f64::from(samples - 1);
    let first = DVec3::splat(-f64::from(size) / 2.0);
    let index_to_world = DAffine3 {
        matrix3: glam::DMat3::from_diagonal(DVec3::splat(spacing)),
        translation: first,
    };
    let along = |i: u32| f64::from(i) * spacing;
    let mut values = Vec::with_capacity(room);
    values.extend(
        (0..samples)
            .flat_map(|z| (0..samples).flat_map(move |y| (0..samples).map(move |x| [x, y, z])))
            .map(|index| field.value(first + DVec3::from_array(index.map(along))) as f32),
    );
    let dims = [samples as usize; 3];
    Ok(Volume::new(field.name(), dims, values, index_to_world)
        .expect("a field in its ranges has finite values"))
}

fn checked(field: &dyn Field) -> Result<Volume> {
    let refused = |refusal: Refusal| Error::scene(refusal.what, refusal.remedy);
    MemoryLimit::of_machine()
        .check(bytes(field).map_err(refused)?)
        .map_err(|shortage| shortage.of("the samples"))?;
    sampled(field).map_err(refused)
}

/// The range of stored values, which is far from the largest f32.
const VALUE: [f32; 2] = [-1e6, 1e6];
