//! Two fields of one event: the particles and the energy that a sun throws out.

use glam::DVec3;

use super::{Field, Lattice, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::within;
use crate::words::words;

/// A front that runs from the origin along x, like a coronal mass ejection. It is not a simulation but two smooth
/// fields, 0 to 1, which share a place and differ in shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Ejection {
    /// The lattice on which it is sampled. The sun is in the middle of the cube.
    pub lattice: Lattice,
    /// Which of the two fields.
    pub part: EjectionPart,
    /// The distance of the front from the sun, as a part of half the cube's edge, 0.05 to 1.
    pub front: f32,
    /// Half the angle over which the front spreads, in degrees, 5 to 120.
    pub spread: f32,
}

/// One of the two fields.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum EjectionPart {
    /// The density of particles. The front sweeps up a shell. A wind around the plane z = 0 thins out with the squared
    /// distance, in two spiral arms as a turning sun winds them (Parker 1958).
    #[default]
    Particles,
    /// The energy. It is dense at the front's nose, which frays into seven tongues, and leaves a trail back to the sun.
    Energy,
}

words! { EjectionPart, "part of an ejection",
    Particles "particles" "The density of particles",
    Energy "energy" "The energy",
}

impl Default for Ejection {
    /// The particles, with the front two thirds of the way out.
    fn default() -> Self {
        Self {
            lattice: Lattice::of(64),
            part: EjectionPart::default(),
            front: 0.65,
            spread: 50.0,
        }
    }
}

/// One of the two fields, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn ejection(parameters: &Ejection) -> Result<Volume> {
    checked(parameters)
}

/// A bell curve, 1 in its middle and `width` wide.
fn bell(x: f64, width: f64) -> f64 {
    (-(x / width).powi(2)).exp()
}

impl Field for Ejection {
    fn check(&self) -> Result<(), Refusal> {
        within("front", self.front, [0.05, 1.0])?;
        within("spread", self.spread, [5.0, 120.0])
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "ejection"
    }

    fn value(&self, point: DVec3) -> f64 {
        let point = point * 2.0 / f64::from(self.lattice.size);
        let distance = point.length();
        let angle = point.x.atan2(point.y.hypot(point.z)).to_degrees();
        let aside = (90.0 - angle) / f64::from(self.spread);
        // The front lags behind at its flanks.
        let front = f64::from(self.front) * (1.0 - 0.15 * aside.powi(2)).max(0.5);
        let behind = front - distance;
        match self.part {
            EjectionPart::Particles => {
                let shell = bell(behind, 0.08) * bell(aside, 1.0);
                let arms = 0.5 + 0.5 * (2.0 * point.y.atan2(point.x) + 12.0 * distance).cos();
                let wind = arms * bell(point.z, 0.05 + 0.15 * distance);
                (0.9 * shell + 0.3 * wind / (1.0 + 12.0 * distance.powi(2))).min(1.0)
            }
            EjectionPart::Energy => {
                let tongues = 1.0 + 0.12 * (7.0 * point.z.atan2(point.y)).cos();
                let nose = bell(behind, 0.12) * bell(aside * tongues, 0.5);
                let trail = 0.35 * bell(aside, 0.3) * (1.0 - distance / front).clamp(0.0, 1.0);
                (0.65 * nose + trail).min(1.0)
            }
        }
    }
}
