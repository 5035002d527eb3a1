//! What is to be rendered: meshes, volumes, a camera, a background. No GL.
//!
//! A scene comes from a TOML scene file ([`Scene::load`]), from a bare model file, or from code.
//! Everything is resolved when it is loaded: the camera is fitted, colours and opacities are per vertex, polygons are
//! triangles, normals are there. What had to be repaired or left out on the way is said in [`Scene::notices`].

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

/// What loading goes by.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// Width and height of the image in pixels, instead of the file's. What is fitted of the camera is fitted to them.
    pub size: Option<[u32; 2]>,
    /// How much memory the scene may take. What would take more is refused before it is allocated. The default is what
    /// the machine has left.
    pub memory: MemoryLimit,
}

impl From<Option<[u32; 2]>> for LoadOptions {
    /// For images of this size, if there is one.
    fn from(size: Option<[u32; 2]>) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }
}

/// Everything an image depends on.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Name for reports: the file's stem or the generator's name.
    pub name: String,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Linear RGB, opaque.
    pub background: [f32; 3],
    /// From where it is seen.
    pub camera: Camera,
    /// In the order of submission, which decides between coplanar surfaces.
    pub meshes: Vec<Mesh>,
    /// In no particular order: where they overlap they are sampled together.
    pub volumes: Vec<Volume>,
    /// What was repaired, skipped or assumed while loading, a sentence each, for the user.
    pub notices: Vec<String>,
}

impl Scene {
    /// The size of an image that nobody asked for another size.
    pub const DEFAULT_SIZE: [u32; 2] = [1024, 768];

    /// Reads a scene file (`.toml`) or a bare model (`.obj`, shaded [`Shading::Lit`] and seen by a fitted camera).
    ///
    /// # Errors
    /// [`Error::Input`] with the file, and as far as known the line and the token, for everything that is wrong with it
    /// or with a file it names: it is not there, too large ([`MAX_BYTES`]), not text, truncated; a key is unknown, a
    /// value of the wrong type or out of range; a face names a vertex that is not there, or a model has none to draw.
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        Self::load_at(path, None)
    }

    /// Reads the same, for an image of another size than the file asks for. What is fitted of the camera is fitted to
    /// that size.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn load_at(path: impl AsRef<Path>, size: Option<[u32; 2]>) -> Result<Self> {
        Self::load_with(path, &size.into())
    }

    /// Reads the same by options.
    ///
    /// # Errors
    /// As [`Scene::load`]; or it takes more memory than the options allow.
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

    /// Meshes in front of black, seen by a fitted camera.
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

    /// The same scene with volumes, too, the camera as it is.
    #[must_use]
    pub fn with_volumes(mut self, volumes: Vec<Volume>) -> Self {
        self.volumes = volumes;
        self
    }

    /// The box of all vertices of all meshes and all corners of all volumes; `None` if there are none.
    pub fn bounds(&self) -> Option<Bounds> {
        joined(&self.meshes, &self.volumes)
    }

    /// How many triangles there are in all.
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
