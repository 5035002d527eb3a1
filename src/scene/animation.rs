//! A scene in time: a camera path, and which meshes and volumes are shown in which frames.

use std::ops::Range;

use bytemuck::cast_slice;
use flate2::Crc;

use super::camera::Camera;
use super::contents::{Scene, joined};
use super::fit::PartialCamera;
use super::path::CameraPath;
use crate::error::{Error, Result};

/// A scene and its camera path. Every frame is a function of its number.
#[derive(Clone, Debug)]
pub struct Animation {
    /// Everything that is shown at any time, seen as in frame 0.
    pub scene: Scene,
    /// Where the camera goes.
    pub path: CameraPath,
    /// Whether the scene file has a path. If it has none, `path` is the default.
    pub has_path: bool,
    pub(super) wish: PartialCamera,
    pub(super) shows: Shows,
}

/// Which meshes and volumes are shown in which frames. A show is a list of names. The sources of a name are stored
/// once, so that many shows of many names take no more memory than their sum.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Shows {
    /// The meshes and volumes of each name.
    pub(super) named: Vec<Named>,
    /// The shows, in the order of their frames. Before the first show everything is shown.
    pub(super) shows: Vec<Show>,
}

/// The meshes and volumes of one name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Named {
    pub(super) meshes: Vec<Range<usize>>,
    pub(super) volumes: Vec<Range<usize>>,
}

/// From this frame on, the meshes and volumes with these names are shown, and nothing else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Show {
    pub(super) from: u32,
    /// Places in [`Shows::named`], in ascending order, without repetition.
    pub(super) names: Vec<usize>,
}

impl Shows {
    /// The meshes and volumes that a frame shows, in the scene's order, or `None` if the frame shows everything.
    fn at(&self, frame: u32) -> Option<Named> {
        let begun = self.shows.partition_point(|show| show.from <= frame);
        let show = &self.shows[begun.checked_sub(1)?];
        let named = || show.names.iter().map(|&name| &self.named[name]);
        let mut meshes: Vec<_> = named().flat_map(|n| &n.meshes).cloned().collect();
        let mut volumes: Vec<_> = named().flat_map(|n| &n.volumes).cloned().collect();
        meshes.sort_unstable_by_key(|range| range.start);
        volumes.sort_unstable_by_key(|range| range.start);
        Some(Named { meshes, volumes })
    }

    /// The first frame after `frame` that shows other meshes or volumes, if there is one.
    fn change_after(&self, frame: u32) -> Option<u32> {
        let begun = self.shows.partition_point(|show| show.from <= frame);
        self.shows.get(begun).map(|show| show.from)
    }
}

impl Animation {
    /// The scene of one frame.
    ///
    /// # Errors
    /// There is no such frame.
    pub fn frame(&self, frame: u32) -> Result<Scene> {
        let camera = self.camera(frame)?;
        let whole = &self.scene;
        let (meshes, volumes) = match self.shows.at(frame) {
            Some(shown) => (
                pick(&whole.meshes, &shown.meshes),
                pick(&whole.volumes, &shown.volumes),
            ),
            None => (whole.meshes.clone(), whole.volumes.clone()),
        };
        let scene = Scene {
            name: whole.name.clone(),
            notices: whole.notices.clone(),
            meshes,
            volumes,
            camera,
            ..*whole
        };
        Ok(scene)
    }

    /// The camera of one frame.
    ///
    /// # Errors
    /// There is no such frame.
    pub fn camera(&self, frame: u32) -> Result<Camera> {
        if frame >= self.path.frames {
            return Err(Error::usage(
                format!("there is no frame {frame}: there are {}", self.path.frames),
                "Frames count from 0.",
            ));
        }
        let first = self.scene.camera;
        // Clip planes that the file does not give follow the eye.
        let moved = PartialCamera {
            eye: Some(self.path.eye(&first, frame)),
            target: Some(first.target),
            up: Some(first.up),
            fov: Some(first.fov),
            ..self.wish
        };
        let all = joined(&self.scene.meshes, &self.scene.volumes);
        let camera = moved.fit(all, self.scene.size);
        camera.check()?;
        Ok(camera)
    }

    /// Cuts frames into spans that show the same meshes and volumes: from frame to frame of a span, only the camera moves.
    pub fn spans(&self, frames: Range<u32>) -> Vec<Range<u32>> {
        let mut spans = Vec::new();
        let mut start = frames.start;
        while start < frames.end {
            let change = self.shows.change_after(start);
            let end = change.map_or(frames.end, |change| change.min(frames.end));
            spans.push(start..end);
            start = end;
        }
        spans
    }

    /// A checksum of everything that the frames depend on, except how they are rendered.
    pub fn fingerprint(&self) -> u32 {
        let scene = &self.scene;
        let mut crc = Crc::new();
        let (size, background) = (scene.size, scene.background);
        let what = (
            size,
            background,
            scene.camera,
            self.wish,
            &self.path,
            &self.shows,
        );
        crc.update(format!("{what:?}").as_bytes());
        for mesh in &scene.meshes {
            let look = (mesh.shading, mesh.inside, mesh.opaque, mesh.sorted);
            crc.update(format!("{look:?}").as_bytes());
            for vertex in &mesh.vertices {
                crc.update(cast_slice(&vertex.position.to_array()));
                crc.update(cast_slice(&vertex.normal.to_array()));
                crc.update(cast_slice(&vertex.color.to_array()));
            }
            crc.update(cast_slice(&mesh.triangles));
        }
        for volume in &scene.volumes {
            let look = (
                volume.dims(),
                volume.index_to_world(),
                volume.step,
                &volume.transfer,
            );
            crc.update(format!("{look:?}").as_bytes());
            crc.update(cast_slice(volume.samples()));
        }
        crc.sum()
    }
}

fn pick<T: Clone>(all: &[T], ranges: &[Range<usize>]) -> Vec<T> {
    let picked = ranges.iter().flat_map(|range| &all[range.clone()]);
    picked.cloned().collect()
}
