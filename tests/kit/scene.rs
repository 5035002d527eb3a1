//! What the tests of scenes share: files in a folder of their own, and errors looked at closely.

pub mod measure;
pub mod model;
pub mod square;

use std::path::PathBuf;

use onionskin::low_level::error::Place;
use onionskin::{Error, Mesh, Scene};
use tempfile::TempDir;

/// A folder that goes away with it.
pub struct Folder(TempDir);

impl Folder {
    /// An empty one.
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a temporary folder"))
    }

    /// Writes a file there.
    pub fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        std::fs::write(self.path(name), content).expect("the folder can be written to");
        self
    }

    /// The path of a file there.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Loads a file there.
    pub fn load(&self, name: &str) -> Result<Scene, Error> {
        Scene::load(self.path(name))
    }
}

/// The scene of a model with this content.
pub fn obj(content: impl AsRef<[u8]>) -> Scene {
    let folder = Folder::new().with("model.obj", content);
    folder.load("model.obj").unwrap_or_else(|e| panic!("{e}"))
}

/// The only mesh of a model with this content.
pub fn obj_mesh(content: impl AsRef<[u8]>) -> Mesh {
    let [mesh] = <[Mesh; 1]>::try_from(obj(content).meshes).expect("one mesh");
    mesh
}

/// The scene of a scene file with this content.
pub fn toml(content: &str) -> Scene {
    let folder = Folder::new().with("scene.toml", content);
    folder.load("scene.toml").unwrap_or_else(|e| panic!("{e}"))
}

/// What an input error says: file name, line, token, what is wrong.
#[derive(Debug)]
pub struct Refused {
    pub file: String,
    pub line: Option<usize>,
    pub token: Option<String>,
    pub what: String,
    pub remedy: String,
}

impl Refused {
    /// Whether line and token are these.
    #[track_caller]
    pub fn at(self, line: usize, token: &str) -> Self {
        assert_eq!(self.line, Some(line), "{self:?}");
        assert_eq!(self.token.as_deref(), Some(token), "{self:?}");
        self
    }

    /// Whether it says this.
    #[track_caller]
    pub fn says(self, part: &str) -> Self {
        assert!(self.what.contains(part), "{self:?}");
        self
    }

    /// Whether it suggests this.
    #[track_caller]
    pub fn suggests(self, part: &str) -> Self {
        assert!(self.remedy.contains(part), "{self:?}");
        self
    }
}

/// The input error of a result, which must be one.
#[track_caller]
pub fn refused<T>(result: Result<T, Error>) -> Refused {
    match result {
        Err(Error::Input {
            place,
            what,
            remedy,
            ..
        }) => {
            assert!(!remedy.is_empty());
            told(place, what, remedy)
        }
        Err(Error::Memory {
            place: Some(place),
            what,
            ..
        }) => told(place, what, "Ask for less, or allow more memory.".into()),
        Err(other) => panic!("not an input error: {other:?}"),
        Ok(_) => panic!("this was accepted"),
    }
}

fn told(place: Place, what: String, remedy: String) -> Refused {
    let file = place.file.file_name();
    Refused {
        file: file.map_or(String::new(), |f| f.to_string_lossy().into()),
        line: place.line,
        token: place.token,
        what,
        remedy,
    }
}

/// The error of a model with this content.
#[track_caller]
pub fn bad_obj(content: impl AsRef<[u8]>) -> Refused {
    refused(Folder::new().with("model.obj", content).load("model.obj"))
}

/// The error of a scene file with this content.
#[track_caller]
pub fn bad_toml(content: &str) -> Refused {
    refused(Folder::new().with("scene.toml", content).load("scene.toml"))
}
