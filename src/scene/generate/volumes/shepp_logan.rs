//! The phantom of a head on which methods of tomography are tested.

use glam::DVec3;

use super::{Field, Lattice, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::{LENGTH, within};

/// The three-dimensional Shepp-Logan phantom with Toft's contrasts: ten ellipsoids, whose values add up. The skull has
/// the value 1, the brain 0.2, the ventricles 0, small tumours 0.3, and the space around the head 0. z points to the
/// crown, y to the front.
#[derive(Clone, Debug, PartialEq)]
pub struct SheppLogan {
    /// The lattice on which it is sampled. The head fills 0.92 of the cube's edge.
    pub lattice: Lattice,
    /// How far an ellipsoid's soft surface reaches inwards and outwards, about, 0 (a hard surface, between two samples) to
    /// 1e6. The value changes there as a smooth step. With hard surfaces, images show rings where the lattice's planes cut
    /// the skull. Real scans have soft ones, because a scanner takes the mean over a sample's surroundings.
    pub softness: f32,
}

impl Default for SheppLogan {
    fn default() -> Self {
        Self {
            lattice: Lattice::of(96),
            softness: 0.0,
        }
    }
}

/// The phantom, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn shepp_logan(parameters: &SheppLogan) -> Result<Volume> {
    checked(parameters)
}

/// The ellipsoids in a cube from -1 to 1: value, half axes, middle, and angle about z in degrees. They are those of
/// Shepp and Logan (1974) in the plane, of Kak and Slaney (1988, chapter 3) in space, with the values of Toft (1996,
/// appendix B).
const ELLIPSOIDS: [(f64, [f64; 3], [f64; 3], f64); 10] = [
    (1.0, [0.69, 0.92, 0.81], [0.0, 0.0, 0.0], 0.0),
    (-0.8, [0.6624, 0.874, 0.78], [0.0, -0.0184, 0.0], 0.0),
    (-0.2, [0.11, 0.31, 0.22], [0.22, 0.0, 0.0], -18.0),
    (-0.2, [0.16, 0.41, 0.28], [-0.22, 0.0, 0.0], 18.0),
    (0.1, [0.21, 0.25, 0.41], [0.0, 0.35, -0.15], 0.0),
    (0.1, [0.046, 0.046, 0.05], [0.0, 0.1, 0.25], 0.0),
    (0.1, [0.046, 0.046, 0.05], [0.0, -0.1, 0.25], 0.0),
    (0.1, [0.046, 0.023, 0.05], [-0.08, -0.605, 0.0], 0.0),
    (0.1, [0.023, 0.023, 0.02], [0.0, -0.606, 0.0], 0.0),
    (0.1, [0.023, 0.046, 0.02], [0.06, -0.605, 0.0], 0.0),
];

impl Field for SheppLogan {
    fn check(&self) -> Result<(), Refusal> {
        within("softness", self.softness, [0.0, LENGTH[1]])
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "shepp-logan"
    }

    fn value(&self, point: DVec3) -> f64 {
        let scale = 2.0 / f64::from(self.lattice.size);
        let (point, softness) = (point * scale, f64::from(self.softness) * scale);
        let parts = ELLIPSOIDS.iter().map(|(value, axes, middle, degrees)| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let seen = point - DVec3::from_array(*middle);
            let turned = DVec3::new(
                seen.x * cos + seen.y * sin,
                seen.y * cos - seen.x * sin,
                seen.z,
            );
            value * part_inside(turned, DVec3::from_array(*axes), softness)
        });
        parts.sum()
    }
}

/// How much a point belongs to an ellipsoid with a soft surface, 0 to 1.
fn part_inside(point: DVec3, axes: DVec3, softness: f64) -> f64 {
    let unit = point / axes;
    let outwards = unit.length() - 1.0;
    // The distance from the surface, to first order: by the gradient of `outwards`.
    let slope = (unit / axes).length() / unit.length();
    if softness == 0.0 || !slope.is_finite() {
        return if outwards <= 0.0 { 1.0 } else { 0.0 };
    }
    let part = (0.5 - outwards / slope / softness * 0.5).clamp(0.0, 1.0);
    part * part * (3.0 - 2.0 * part)
}
