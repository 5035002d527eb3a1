//! A field that is the same everywhere. It lets exactly exp(-density x length) of the light through.

use glam::DVec3;

use super::{Field, Lattice, VALUE, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::within;

/// A field of one value.
#[derive(Clone, Debug, PartialEq)]
pub struct Constant {
    /// The lattice on which it is sampled.
    pub lattice: Lattice,
    /// The value, -1e6 to 1e6.
    pub value: f32,
}

impl Default for Constant {
    /// The value 1 in a cube from -1 to 1.
    fn default() -> Self {
        Self {
            lattice: Lattice::of(2),
            value: 1.0,
        }
    }
}

/// A field of one value, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn constant(parameters: &Constant) -> Result<Volume> {
    checked(parameters)
}

impl Field for Constant {
    fn check(&self) -> Result<(), Refusal> {
        within("value", self.value, VALUE)
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "constant"
    }

    fn value(&self, _: DVec3) -> f64 {
        f64::from(self.value)
    }
}
