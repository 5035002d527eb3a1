//! Scenes: meshes, volumes, a camera, a background. No GL.
//!
//! A scene comes from a TOML scene file ([`Scene::load`]), from a bare model file, or from code. Everything is resolved
//! when the scene is loaded: the camera is fitted, colours and opacities belong to vertices, polygons are triangles,
//! and every vertex has a normal. [`Scene::notices`] says what was repaired or left out.

mod animation;
mod bounds;
mod camera;
mod chance;
mod file;
mod fit;
pub mod generate;
mod mesh;
mod normals;
mod obj;
mod path;
mod source;
mod stack;
mod transform;
mod volume;

use std::path::Path;

pub use animation::Animation;
pub use bounds::Bounds;
pub use camera::Camera;
pub use fit::PartialCamera;
pub use mesh::{Mesh, Shading, Vertex};
pub use path::CameraPath;
pub use source::MAX_BYTES;
pub use transform::Transform;
pub use volume::{MAX_SAMPLES, Medium, Transfer, TransferPoint, Volume};

use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;

/// Options for loading a scene.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// Width and height of the image in pixels, instead of the file's. The camera is fitted to this size.
    pub size: Option<[u32; 2]>,
    /// The memory that the scene may take. A scene that would take more is refused before its memory is allocated. The
    /// default is the memory that the machine has left.
    pub memory: MemoryLimit,
}

impl From<Option<[u32; 2]>> for LoadOptions {
    /// The default options, for images of this size, or of the file's size if `None`.
    fn from(size: Option<[u32; 2]>) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }
}

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

    /// Reads a scene file (`.toml`) or a bare model (`.obj`, shaded [`Shading::Lit`] and seen by a fitted camera).
    ///
    /// # Errors
    /// [`Error::Input`] for everything that is wrong with the file or with a file that it names. It has the file and,
    /// as far as they are known, the line and the token. A file may be missing, too large ([`MAX_BYTES`]), not text, or
    /// truncated. A key may be unknown, a value may have the wrong type or be out of range. A face may name a vertex
    /// that does not exist, or a model may have no face to draw.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        Self::load_at(path, None)
    }

    /// Reads the same for an image of another size than the file asks for. The camera is fitted to this size.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn load_at(path: impl AsRef<Path>, size: Option<[u32; 2]>) -> Result<Self> {
        Self::load_with(path, &size.into())
    }

    /// Reads the same with options.
    ///
    /// # Errors
    /// As [`Scene::load`], and if the scene takes more memory than the options allow.
    pub fn load_with(path: impl AsRef<Path>, options: &LoadOptions) -> Result<Self> {
        let path = path.as_ref();
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("toml") => Ok(file::load(path, options)?.scene),
            Some("obj") => Self::load_model(path, options),
            _ => Err(Error::input(
                Place::file(path),
                "this is neither a scene file nor a model that can be read",
                "Give a scene file (.toml) or a Wavefront model (.obj).",
            )),
        }
    }

    /// A scene of meshes in front of black, with a fitted camera.
    pub fn of(name: impl Into<String>, meshes: Vec<Mesh>) -> Self {
        Self::of_size(name, meshes, Self::DEFAULT_SIZE)
    }

    fn of_size(name: impl Into<String>, meshes: Vec<Mesh>, size: [u32; 2]) -> Self {
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

    fn load_model(path: &Path, options: &LoadOptions) -> Result<Self> {
        let model = obj::load(path, &obj::Paint::default(), &options.memory)?;
        let size = options.size.unwrap_or(Self::DEFAULT_SIZE);
        let mut scene = Self::of_size(stem(path), model.meshes, size);
        scene.notices = model.notices;
        for mesh in &mut scene.meshes {
            mesh.shading = Shading::Lit;
        }
        Ok(scene)
    }
}

fn joined(meshes: &[Mesh], volumes: &[Volume]) -> Option<Bounds> {
    let of_meshes = meshes.iter().filter_map(Mesh::bounds);
    let boxes = of_meshes.chain(volumes.iter().map(Volume::bounds));
    boxes.reduce(Bounds::joined)
}

fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}
