//! A ball of fog.

use glam::DVec3;

use super::{Field, Lattice, VALUE, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::{LENGTH, within};

/// A ball at the origin. It has one value inside and 0 outside, with a soft surface between.
#[derive(Clone, Debug, PartialEq)]
pub struct Ball {
    /// The lattice on which it is sampled.
    pub lattice: Lattice,
    /// The radius at which the value is half of the value inside, 1e-6 to 1e6.
    pub radius: f32,
    /// How far the soft surface reaches inwards and outwards, 0 (a hard surface, between two samples) to 1e6. The value
    /// falls there as a smooth step.
    pub softness: f32,
    /// The value inside, -1e6 to 1e6.
    pub value: f32,
}

impl Default for Ball {
    /// A ball of radius 0.8 with the value 1 inside.
    fn default() -> Self {
        Self {
            lattice: Lattice::of(64),
            radius: 0.8,
            softness: 0.1,
            value: 1.0,
        }
    }
}

/// A ball, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn ball(parameters: &Ball) -> Result<Volume> {
    checked(parameters)
}

impl Field for Ball {
    fn check(&self) -> Result<(), Refusal> {
        within("radius", self.radius, LENGTH)?;
        within("softness", self.softness, [0.0, LENGTH[1]])?;
        within("value", self.value, VALUE)
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "ball"
    }

    fn value(&self, point: DVec3) -> f64 {
        let [radius, softness, value] = [self.radius, self.softness, self.value].map(f64::from);
        let inwards = radius - point.length();
        if softness == 0.0 {
            return if inwards >= 0.0 { value } else { 0.0 };
        }
        let part = (inwards / softness * 0.5 + 0.5).clamp(0.0, 1.0);
        value * part * part * (3.0 - 2.0 * part)
    }
}
