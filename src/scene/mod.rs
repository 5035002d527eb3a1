//! Scenes: meshes, volumes, a camera, a background. No GL.
//!
//! A scene comes from a TOML scene file ([`Scene::load`]), from a bare model file, or from code. Everything is resolved
//! when the scene is loaded: the camera is fitted, colours and opacities belong to vertices, polygons are triangles,
//! and every vertex has a normal. [`Scene::notices`] says what was repaired or left out.

#[cfg(feature = "formats")]
mod animation;
mod axes;
mod bounds;
mod camera;
mod chance;
mod contents;
#[cfg(feature = "formats")]
mod file;
mod fit;
pub mod generate;
#[cfg(feature = "formats")]
mod load;
mod mesh;
mod normals;
#[cfg(feature = "formats")]
mod obj;
#[cfg(feature = "formats")]
mod options;
mod path;
#[cfg(feature = "formats")]
mod source;
mod stack;
mod transform;
mod volume;

#[cfg(feature = "formats")]
pub use animation::Animation;
pub use axes::Axes;
pub use bounds::Bounds;
pub use camera::Camera;
pub use contents::Scene;
pub use fit::PartialCamera;
pub use mesh::{Mesh, Shading, Vertex};
#[cfg(feature = "formats")]
pub use options::LoadOptions;
pub use path::CameraPath;
#[cfg(feature = "formats")]
pub use source::MAX_BYTES;
pub use transform::Transform;
pub use volume::{MAX_SAMPLES, Medium, Transfer, TransferPoint, Volume};
