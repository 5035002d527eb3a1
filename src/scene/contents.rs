//! A scene: everything that an image depends on.

use super::bounds::Bounds;
use super::camera::Camera;
use super::fit::PartialCamera;
use super::mesh::Mesh;
use super::volume::Volume;

/// Everything that an image depends on.
///
/// The exact image of triangles of one's own:
///
/// ```
/// use onionskin::{Camera, Context, Mesh, Method, Renderer, Rgba, Scene, Vertex};
///
/// let corner = |x, y| Vertex { position: [x, y, 0.0].into(), ..Vertex::default() };
/// let corners = vec![corner(-1.0, -1.0), corner(3.0, -1.0), corner(-1.0, 3.0)];
/// let glass = Mesh::new("glass", corners, vec![[0, 1, 2]]).painted(Rgba::new(1.0, 0.0, 0.0, 0.5));
/// let camera = Camera { near: 1.0, far: 10.0, ..Camera::looking([0.0, 0.0, 2.0].into(), [0.0; 3].into()) };
/// let scene = Scene::new(camera, [8, 8]).with_background([1.0; 3]).with_mesh(glass);
/// let image = Renderer::new(&Context::headless()?, 8, 8)?.render(&scene, &Method::Exact)?.image;
/// assert_eq!(image.pixel(4, 4), Rgba::opaque([1.0, 0.5, 0.5]));
/// # Ok::<(), onionskin::Error>(())
/// ```
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

    /// A scene without anything in it, in front of black: `size` is the image's width and height in pixels.
    pub fn new(camera: Camera, size: [u32; 2]) -> Self {
        Self {
            camera,
            ..Self::of_size("scene", Vec::new(), size)
        }
    }

    /// The same scene with a mesh added, submitted last.
    #[must_use]
    pub fn with_mesh(mut self, mesh: Mesh) -> Self {
        self.meshes.push(mesh);
        self
    }

    /// The same scene in front of another background, linear RGB.
    #[must_use]
    pub fn with_background(mut self, background: [f32; 3]) -> Self {
        self.background = background;
        self
    }

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
