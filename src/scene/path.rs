//! The camera in each frame of an animation.

use std::f64::consts::TAU;

use glam::{DQuat, DVec3};

use super::camera::Camera;

/// The path of a camera around its target. In frame 0 the camera is the scene's.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraPath {
    /// The number of frames, 1 to 1,000,000.
    pub frames: u32,
    /// The angle in degrees by which the eye turns over all frames, about the axis along `up` through the target. The
    /// turn would be complete in frame `frames`, which is the first one after the end, so a full turn shows no view
    /// twice.
    pub rotate: f64,
    /// The distance from the target at the dolly's other end, as a part of the distance in frame 0, greater than 0. 1
    /// means no dolly.
    pub dolly: f64,
    /// The number of frames in which the dolly goes there and back, 2 or more.
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
    /// The position of this camera's eye in a frame.
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
