//! A scene: everything that an image depends on.

use super::bounds::Bounds;
use super::camera::Camera;
use super::fit::PartialCamera;
use super::mesh::Mesh;
use super::volume::Volume;

/// Everything that an image depends on.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Name, for reports: the file's stem or the generator's name.
    pub name: String,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Background colour, linear RGB, opaque.
    pub background: [f32; 3],
    /// The camera.
    pub camera: Camera,
    /// Meshes in the order of submission, which decides between coplanar surfaces.
    pub meshes: Vec<Mesh>,
    /// Volumes, in any order. Where volumes overlap, they are sampled together.
    pub volumes: Vec<Volume>,
    /// What was repaired, skipped or assumed while loading: one sentence each, for the user.
    pub notices: Vec<String>,
}

impl Scene {
    /// The image size, unless the caller asks for another.
    pub const DEFAULT_SIZE: [u32; 2] = [1024, 768];

    /// A scene of meshes in front of black, with a fitted camera.
    pub fn of(name: impl Into<String>, meshes: Vec<Mesh>) -> Self {
        Self::of_size(name, meshes, Self::DEFAULT_SIZE)
    }

    pub(super) fn of_size(name: impl Into<String>, meshes: Vec<Mesh>, size: [u32; 2]) -> Self {
        Self {
            name: name.into(),
            size,
            background: [0.0; 3],
            camera: PartialCamera::default().fit(joined(&meshes, &[]), size),
            meshes,
            volumes: Vec::new(),
            notices: Vec::new(),
        }
    }

    /// The same scene with volumes added. The camera does not change.
    #[must_use]
    pub fn with_volumes(mut self, volumes: Vec<Volume>) -> Self {
        self.volumes = volumes;
        self
    }

    /// The bounding box of all vertices of all meshes and all corners of all volumes, or `None` if the scene is empty.
    pub fn bounds(&self) -> Option<Bounds> {
        joined(&self.meshes, &self.volumes)
    }

    /// The number of triangles of all meshes.
    pub fn triangle_count(&self) -> usize {
        self.meshes.iter().map(Mesh::triangle_count).sum()
    }
}

pub(super) fn joined(meshes: &[Mesh], volumes: &[Volume]) -> Option<Bounds> {
    let of_meshes = meshes.iter().filter_map(Mesh::bounds);
    let boxes = of_meshes.chain(volumes.iter().map(Volume::bounds));
    boxes.reduce(Bounds::joined)
}
