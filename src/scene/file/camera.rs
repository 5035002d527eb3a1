//! `[camera]`.

use glam::DVec3;

use super::keys::Keys;
use super::limits::{ANY, OPENING, POSITIVE};
use crate::error::Result;
use crate::scene::{Bounds, Camera, PartialCamera};

/// The file's keys for the camera, and where they stand.
pub(super) struct CameraKeys<'a> {
    camera: PartialCamera,
    keys: Option<Keys<'a>>,
}

impl<'a> CameraKeys<'a> {
    pub(super) fn read(top: &Keys<'a>) -> Result<Self> {
        let Some(keys) = top.table("camera", "[camera]")? else {
            return Ok(Self {
                camera: PartialCamera::default(),
                keys: None,
            });
        };
        keys.expect_only(&["eye", "target", "up", "fov", "near", "far"])?;
        let vector = |key| Ok(keys.vector(key, &ANY)?.map(DVec3::from_array));
        let camera = PartialCamera {
            eye: vector("eye")?,
            target: vector("target")?,
            up: vector("up")?,
            fov: keys.number("fov", &OPENING)?,
            near: keys.number("near", &POSITIVE)?,
            far: keys.number("far", &POSITIVE)?,
        };
        Ok(Self {
            camera,
            keys: Some(keys),
        })
    }

    /// The parts of the camera that the file gives.
    pub(super) fn partial(&self) -> PartialCamera {
        self.camera
    }

    /// The whole camera. A fault that shows only when the parts are combined is reported at the key that it is about.
    pub(super) fn fit(&self, bounds: Option<Bounds>, size: [u32; 2]) -> Result<Camera> {
        let camera = self.camera.fit(bounds, size);
        match (camera.fault(), &self.keys) {
            (None, _) => Ok(camera),
            (Some(fault), Some(keys)) => {
                let what = format!("the camera's {}", fault.what);
                Err(keys.wrong(fault.key, what, fault.remedy))
            }
            (Some(_), None) => camera.check().map(|()| camera),
        }
    }
}
