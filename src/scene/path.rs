//! Where the camera is in each frame of an animation.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};

use super::camera::Camera;

/// A camera's way around its target. Frame 0 is the scene's own camera.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    /// How many frames there are, 1 to 1,000,000.
    pub frames: u32,
    /// How far the eye turns about the axis through the target along `up`, in degrees, over all frames. Frame `frames`,
    /// the first one that is no more there, would have turned by all of it, so a full turn has no frame twice.
    pub rotate: f64,
    /// The distance from the target at the dolly's other end, as a part of frame 0's; greater than 0. 1 is no dolly.
    pub dolly: f64,
    /// In how many frames the dolly goes there and back, 2 or more.
    pub dolly_frames: u32,
}

impl Default for CameraPath {
    /// A full turn in steps of ten degrees.
    fn default() -> Self {
        Self {
            frames: 36,
            rotate: 360.0,
            dolly: 1.0,
            dolly_frames: 36,
        }
    }
}

impl CameraPath {
    /// Where the eye of this camera is in a frame.
    pub fn eye(&self, camera: &Camera, frame: u32) -> DVec3 {
        let turned = self.rotate.to_radians() * f64::from(frame) / f64::from(self.frames);
        let axis = camera.up.normalize_or(DVec3::Y);
        let away = DQuat::from_axis_angle(axis, turned) * (camera.eye - camera.target);
        // A cosine: the dolly slows down where it turns.
        let phase = TAU * f64::from(frame) / f64::from(self.dolly_frames);
        let there = (1.0 - phase.cos()) / 2.0;
        camera.target + away * (1.0 + (self.dolly - 1.0) * there)
    }
}
