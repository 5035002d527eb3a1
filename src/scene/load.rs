//! Loading a scene from a file, by the ending of its name.

use std::path::Path;

use super::animation::{Animation, Shows};
use super::contents::Scene;
use super::fit::PartialCamera;
use super::mesh::Shading;
use super::options::LoadOptions;
use super::path::CameraPath;
use super::source::stem;
use super::{file, obj};
use crate::error::{Error, Place, Result};

impl Scene {
    /// Reads a scene file (`.toml`) or a bare model (`.obj`, shaded [`Shading::Lit`] and seen by a fitted camera).
    ///
    /// # Errors
    /// [`Error::Input`] for everything that is wrong with the file or with a file that it names. It has the file and,
    /// as far as they are known, the line and the token. A file may be missing, too large ([`MAX_BYTES`](super::MAX_BYTES)), not text, or
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

impl Animation {
    /// Reads a scene file with its `[path]`. A scene file or a model without a path turns once, as in
    /// [`CameraPath::default`].
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn load(path: impl AsRef<Path>) -> Result<Self> {
        Self::load_at(path, None)
    }

    /// Reads the same, for images of another size than the file asks for.
    ///
    /// # Errors
    /// As [`Scene::load`].
    pub fn load_at(path: impl AsRef<Path>, size: Option<[u32; 2]>) -> Result<Self> {
        Self::load_with(path, &size.into())
    }

    /// Reads the same with options.
    ///
    /// # Errors
    /// As [`Scene::load_with`].
    pub fn load_with(path: impl AsRef<Path>, options: &LoadOptions) -> Result<Self> {
        let path = path.as_ref();
        if path
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
        {
            return file::load(path, options);
        }
        Ok(Self {
            scene: Scene::load_with(path, options)?,
            path: CameraPath::default(),
            has_path: false,
            wish: PartialCamera::default(),
            shows: Shows::default(),
        })
    }
}
