//! Meshes: triangles in their order of submission.

use glam::{DVec3, Vec3};

use super::bounds::Bounds;
use super::chance::Chance;
use super::normals;
use crate::fragment::Rgba;
use crate::words::words;

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// Position in world space, finite. It is f64, because maps and building plans have coordinates of millions of
    /// metres, and because the oracle decides by it which surface lies in front. A driver gets the position relative to
    /// the scene, in 32 bits.
    pub position: DVec3,
    /// Normal in world space, of unit length, towards the outside.
    pub normal: Vec3,
    /// Colour of the outside, with straight alpha.
    pub color: Rgba,
}

/// How a fragment gets its colour from the vertices' colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Shading {
    /// The vertices' colour as it is.
    #[default]
    None,
    /// Light from the eye, with one normal per triangle.
    Flat,
    /// Light from the eye, with interpolated normals.
    Lit,
    /// As `Lit`. The outside has the vertices' colour, the inside has [`Mesh::inside`].
    TwoSided,
    /// The colour of the scene's volumes at the fragment's place, as opaque as the slab that the slice stands for.
    /// Outside of all volumes the fragment is clear. The renderer uses this for slices of volumes; no scene file can
    /// name it.
    Slice,
}

words! { Shading, "shading",
    None "none" "The vertices' colour as it is",
    Flat "flat" "Light from the eye, with one normal per triangle",
    Lit "lit" "Light from the eye, with interpolated normals",
    TwoSided "two-sided" "Light from the eye, with a colour for each side",
}

/// A list of triangles.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Name, for messages.
    pub name: String,
    /// Corners.
    pub vertices: Vec<Vertex>,
    /// The three corners of each triangle, counter-clockwise as seen from outside. Triangles are in the order of
    /// submission.
    pub triangles: Vec<[u32; 3]>,
    /// The shading.
    pub shading: Shading,
    /// Linear RGB of back faces under [`Shading::TwoSided`]; their opacity is the vertices'.
    pub inside: [f32; 3],
    /// Whether the mesh is drawn first, with depth writes. This is so if every vertex has alpha 1 and the scene file
    /// does not say otherwise.
    pub opaque: bool,
    /// Whether the triangles, ordered by their depth along the view direction, are sorted exactly, as slices and
    /// sprites are.
    pub sorted: bool,
}

impl Mesh {
    /// A mesh of unlit triangles. It is opaque if every vertex is. The inside has the colour of the first vertex.
    pub fn new(name: impl Into<String>, vertices: Vec<Vertex>, triangles: Vec<[u32; 3]>) -> Self {
        let first = vertices.first().map_or(Rgba::default(), |v| v.color);
        Self {
            name: name.into(),
            opaque: is_opaque(&vertices),
            inside: [first.r, first.g, first.b],
            vertices,
            triangles,
            ..Self::default()
        }
    }

    /// The memory that the vertices and triangles take, in bytes.
    pub fn bytes(&self) -> u64 {
        bytes(self.vertices.len() as u64, self.triangles.len() as u64)
    }

    /// The number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The bounding box of the vertices, or `None` if there is no vertex.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.vertices.iter().map(|v| v.position))
    }

    /// The three corners of a triangle. It must exist.
    pub fn corners(&self, triangle: usize) -> [Vertex; 3] {
        self.triangles[triangle].map(|corner| self.vertices[corner as usize])
    }

    /// The same mesh in one colour and opacity, inside and outside.
    #[must_use]
    pub fn painted(mut self, color: Rgba) -> Self {
        for vertex in &mut self.vertices {
            vertex.color = color;
        }
        self.inside = [color.r, color.g, color.b];
        self.opaque = is_opaque(&self.vertices);
        self
    }

    /// The same triangles in the same order, each with three vertices of its own, which have the triangle's normal.
    /// [`Shading::Flat`] needs this. A triangle without area gets +z.
    #[must_use]
    pub fn with_face_normals(&self) -> Self {
        let corners = (0..self.triangles.len()).flat_map(|triangle| {
            let corners = self.corners(triangle);
            let normal = normals::face(corners.map(|corner| corner.position));
            corners.map(|corner| Vertex { normal, ..corner })
        });
        let vertices: Vec<Vertex> = corners.collect();
        let count = u32::try_from(vertices.len()).expect("fewer than u32::MAX corners");
        let triangles = (0..count).step_by(3).map(|i| [i, i + 1, i + 2]).collect();
        Self {
            name: self.name.clone(),
            vertices,
            triangles,
            ..*self
        }
    }

    /// The same mesh with its triangles in another order of submission, which depends on the seed. Nothing else
    /// changes.
    #[must_use]
    pub fn shuffled(&self, seed: u64) -> Self {
        let mut mesh = self.clone();
        Chance::new(seed).shuffle(&mut mesh.triangles);
        mesh
    }

    /// Removes the triangles that cover nothing, and returns their number.
    pub(super) fn drop_degenerate(&mut self) -> usize {
        let before = self.triangles.len();
        let vertices = &self.vertices;
        self.triangles.retain(|triangle| {
            !normals::is_degenerate(triangle.map(|corner| vertices[corner as usize].position))
        });
        before - self.triangles.len()
    }
}

/// The memory that so many vertices and triangles take, in bytes.
pub(super) fn bytes(vertices: u64, triangles: u64) -> u64 {
    let of_vertices = vertices.saturating_mul(size_of::<Vertex>() as u64);
    of_vertices.saturating_add(triangles.saturating_mul(size_of::<[u32; 3]>() as u64))
}

/// Whether every vertex is opaque.
fn is_opaque(vertices: &[Vertex]) -> bool {
    vertices.iter().all(|vertex| vertex.color.a == 1.0)
}
