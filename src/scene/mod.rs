//! Scenes: meshes, volumes, a camera, a background. No GL.
//!
//! A scene comes from a TOML scene file ([`Scene::load`]), from a bare model file, or from code. Everything is resolved
//! when the scene is loaded: the camera is fitted, colours and opacities belong to vertices, polygons are triangles,
//! and every vertex has a normal. [`Scene::notices`] says what was repaired or left out.

mod animation;
mod bounds;
mod camera;
mod chance;
mod contents;
mod file;
mod fit;
pub mod generate;
mod load;
mod mesh;
mod normals;
mod obj;
mod options;
mod path;
mod source;
mod stack;
mod transform;
mod volume;

pub use animation::Animation;
pub use bounds::Bounds;
pub use camera::Camera;
pub use contents::Scene;
pub use fit::PartialCamera;
pub use mesh::{Mesh, Shading, Vertex};
pub use options::LoadOptions;
pub use path::CameraPath;
pub use source::MAX_BYTES;
pub use transform::Transform;
pub use volume::{MAX_SAMPLES, Medium, Transfer, TransferPoint, Volume};
