//! A field that is linear from one face to the opposite one. Trilinear interpolation of it is exact.

use glam::DVec3;

use super::{Field, Lattice, VALUE, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::within;

/// A field that is linear along z and constant along x and y.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    /// The lattice on which it is sampled.
    pub lattice: Lattice,
    /// The value at the smallest z, -1e6 to 1e6.
    pub from: f32,
    /// The value at the largest z, -1e6 to 1e6.
    pub to: f32,
}

impl Default for Gradient {
    /// A field from 0 to 1 in a cube from -1 to 1.
    fn default() -> Self {
        Self {
            lattice: Lattice::of(2),
            from: 0.0,
            to: 1.0,
        }
    }
}

/// A field that is linear along z, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn gradient(parameters: &Gradient) -> Result<Volume> {
    checked(parameters)
}

impl Field for Gradient {
    fn check(&self) -> Result<(), Refusal> {
        within("from", self.from, VALUE)?;
        within("to", self.to, VALUE)
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "gradient"
    }

    fn value(&self, point: DVec3) -> f64 {
        let part = point.z / f64::from(self.lattice.size) + 0.5;
        let [from, to] = [self.from, self.to].map(f64::from);
        from + (to - from) * part
    }
}
