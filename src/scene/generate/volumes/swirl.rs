//! A flow that turns and rises.

use glam::DVec3;

use super::{Field, Lattice, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::within;

/// A vortex after Lamb and Oseen whose axis winds around z, with a jet along the axis. Lengths are parts of half the
/// cube's edge. The samples are the flow's speed, which is of order 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swirl {
    /// The lattice on which it is sampled.
    pub lattice: Lattice,
    /// The radius of the vortex's core, 0.01 to 1.
    pub core: f32,
    /// The distance of the vortex's axis from the z axis, 0 to 1.
    pub winding: f32,
    /// How often the vortex's axis turns around z from bottom to top, 0 to 10.
    pub turns: f32,
    /// The speed of the jet along the axis, 0 to 10. The speed of the vortex itself is at most 0.64.
    pub jet: f32,
}

impl Default for Swirl {
    fn default() -> Self {
        Self {
            lattice: Lattice::of(64),
            core: 0.2,
            winding: 0.25,
            turns: 1.0,
            jet: 0.5,
        }
    }
}

/// The flow's speed, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn swirl(parameters: &Swirl) -> Result<Volume> {
    checked(parameters)
}

impl Swirl {
    /// The flow at a point of the world.
    pub fn velocity(&self, point: DVec3) -> DVec3 {
        let point = point * 2.0 / f64::from(self.lattice.size);
        let [core, winding, turns, jet] =
            [self.core, self.winding, self.turns, self.jet].map(f64::from);
        let (sin, cos) = (std::f64::consts::PI * turns * point.z).sin_cos();
        let away = DVec3::new(point.x - winding * cos, point.y - winding * sin, 0.0);
        let part = away.length_squared() / (core * core);
        // (1 - exp(-part)) / part, which is 1 on the axis.
        let turning = if part < 1e-8 {
            1.0
        } else {
            -(-part).exp_m1() / part
        };
        let around = DVec3::Z.cross(away) * (turning / core);
        around + DVec3::Z * jet * (-part).exp()
    }
}

impl Field for Swirl {
    fn check(&self) -> Result<(), Refusal> {
        within("core", self.core, [0.01, 1.0])?;
        within("winding", self.winding, [0.0, 1.0])?;
        within("turns", self.turns, [0.0, 10.0])?;
        within("jet", self.jet, [0.0, 10.0])
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "swirl"
    }

    fn value(&self, point: DVec3) -> f64 {
        self.velocity(point).length()
    }
}
