//! A pinhole camera, in f64 until the very last step.

use glam::dcamera::rh::{proj, view};
use glam::{DMat4, DVec3};

use crate::error::{Error, Result};

/// A perspective camera. All lengths are in the scene's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye's position.
    pub eye: DVec3,
    /// The point that the camera looks at.
    pub target: DVec3,
    /// The direction that is up in the image. It need not be perpendicular to the view direction.
    pub up: DVec3,
    /// Vertical field of view in degrees, between 0 and 180.
    pub fov: f64,
    /// Distance of the near plane, positive.
    pub near: f64,
    /// Distance of the far plane, beyond `near`.
    pub far: f64,
}

impl Camera {
    /// A camera at `eye` that looks at `target`: y is up, the field of view is 30 degrees, and the planes are at a
    /// hundredth and at a hundred times the distance between the two.
    pub fn looking(eye: DVec3, target: DVec3) -> Self {
        let distance = eye.distance(target);
        Self {
            eye,
            target,
            up: DVec3::Y,
            fov: 30.0,
            near: distance / 100.0,
            far: distance * 100.0,
        }
    }

    /// World to eye space (right-handed, looking down -z).
    pub fn view(&self) -> DMat4 {
        view::look_at_mat4(self.eye, self.target, self.up)
    }

    /// Eye to clip space, OpenGL's depth range of -1 to 1.
    pub fn projection(&self, width: u32, height: u32) -> DMat4 {
        let aspect = f64::from(width) / f64::from(height);
        proj::opengl::perspective(self.fov.to_radians(), aspect, self.near, self.far)
    }

    /// Checks that the camera can see anything at all.
    ///
    /// # Errors
    /// A number is not finite, the eye is at the target, `up` is zero or along the view direction, or `fov`, `near` or
    /// `far` is out of its range.
    pub fn check(&self) -> Result<()> {
        match self.fault() {
            None => Ok(()),
            Some(fault) => Err(Error::scene(
                format!("the camera's {}", fault.what),
                fault.remedy,
            )),
        }
    }

    /// The first fault, with the key of a scene file that corrects it.
    pub(super) fn fault(&self) -> Option<Fault> {
        let vectors = [("eye", self.eye), ("target", self.target), ("up", self.up)];
        for (key, vector) in vectors {
            if !vector.is_finite() {
                return Fault::of(key, "not finite", "Give three finite numbers.");
            }
        }
        if !(self.fov > 0.0 && self.fov < 180.0) {
            return Fault::of(
                "fov",
                "out of range",
                "Give an angle between 0 and 180 degrees.",
            );
        }
        if !(self.near > 0.0 && self.near.is_finite()) {
            return Fault::of("near", "not positive", "Give a distance greater than 0.");
        }
        if !(self.far > self.near && self.far.is_finite()) {
            return Fault::of("far", "not beyond `near`", "Give a larger distance.");
        }
        let Some(direction) = (self.target - self.eye).try_normalize() else {
            return Fault::of(
                "target",
                "where the eye is",
                "Move one of the two, or leave one out to have it fitted.",
            );
        };
        // If `up` is nearer to the view direction than this, the 32-bit matrices of a renderer cannot tell the two
        // apart.
        const SMALLEST_SINE: f64 = 1e-6;
        let sine = self
            .up
            .try_normalize()
            .map_or(0.0, |up| up.cross(direction).length());
        if sine < SMALLEST_SINE {
            return Fault::of(
                "up",
                "zero or along the view direction",
                "Give a direction that points sideways of the view, or leave `up` out.",
            );
        }
        None
    }
}

/// What is wrong with a camera.
pub(super) struct Fault {
    /// The key of a scene file that corrects it.
    pub(super) key: &'static str,
    /// What is wrong, as a sentence that starts with the key's name.
    pub(super) what: String,
    /// What to do.
    pub(super) remedy: &'static str,
}

impl Fault {
    fn of(key: &'static str, what: &str, remedy: &'static str) -> Option<Self> {
        let what = format!("`{key}` is {what}");
        Some(Self { key, what, remedy })
    }
}
