//! The axes of a view.

use glam::DVec3;

use super::camera::Camera;

/// Three perpendicular directions of length 1, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// To the right in the image.
    pub right: DVec3,
    /// Up in the image.
    pub up: DVec3,
    /// Into the image, away from the eye.
    pub forward: DVec3,
}

impl Axes {
    /// The axes of a view in a direction. `up` need not be perpendicular to it. A direction of no length is taken for -z;
    /// where `up` says nothing, any perpendicular direction will do.
    pub fn of(direction: DVec3, up: DVec3) -> Self {
        let forward = direction.normalize_or(DVec3::NEG_Z);
        let right = forward
            .cross(up)
            .try_normalize()
            .unwrap_or_else(|| (-forward).any_orthonormal_vector());
        Self {
            right,
            up: right.cross(forward),
            forward,
        }
    }
}

impl Camera {
    /// The axes of its view.
    pub fn axes(&self) -> Axes {
        Axes::of(self.target - self.eye, self.up)
    }
}
