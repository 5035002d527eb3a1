//! Triangles, ready to be submitted in their order.

use glam::{DVec3, Vec3};

use super::bounds::Bounds;
use super::chance::Chance;
use super::normals;
use crate::fragment::Rgba;

/// A corner.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// World space, finite. In f64, because maps and building plans have coordinates of millions of metres, and because
    /// the oracle decides by it what lies in front; a driver gets 32 bits of its place in the scene.
    pub position: DVec3,
    /// World space, unit length; points to the outside.
    pub normal: Vec3,
    /// Of the outside, straight alpha.
    pub color: Rgba,
}

/// How a colour comes from a vertex's colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// The colour as it is.
    #[default]
    None,
    /// Lit from the eye, one normal per triangle.
    Flat,
    /// Lit from the eye, normals interpolated.
    Lit,
    /// Lit, the outside in its own colour and the inside in [`Mesh::inside`].
    TwoSided,
    /// What the scene's volumes have at the place, as opaque as the slab that the slice stands for; clear outside of all
    /// of them. Of the slices that the renderer makes of volumes, not of a scene file.
    Slice,
}

/// A list of triangles.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Name for messages.
    pub name: String,
    /// Corners.
    pub vertices: Vec<Vertex>,
    /// Three corners each, counter-clockwise seen from outside; in the order of submission.
    pub triangles: Vec<[u32; 3]>,
    /// How it is shaded.
    pub shading: Shading,
    /// Linear RGB of back faces under [`Shading::TwoSided`]; their opacity is the vertices'.
    pub inside: [f32; 3],
    /// Drawn first, with depth writes: every vertex has alpha 1 (and the scene file does not say otherwise).
    pub opaque: bool,
    /// Its triangles, taken in order of their depth along the view direction, are exactly sorted (slices, sprites).
    pub sorted: bool,
}

impl Mesh {
    /// Unlit triangles; opaque if every vertex is, the inside coloured like the first vertex.
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

    /// How much memory its vertices and triangles take, in bytes.
    pub fn bytes(&self) -> u64 {
        bytes(self.vertices.len() as u64, self.triangles.len() as u64)
    }

    /// How many triangles it has.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The box of its vertices; `None` if there are none.
    pub fn bounds(&self) -> Option<Bounds> {
        Bounds::of(self.vertices.iter().map(|v| v.position))
    }

    /// The three corners of one triangle, which must be there.
    pub fn corners(&self, triangle: usize) -> [Vertex; 3] {
        self.triangles[triangle].map(|corner| self.vertices[corner as usize])
    }

    /// The same in one colour and opacity, inside and outside.
    #[must_use]
    pub fn painted(mut self, color: Rgba) -> Self {
        for vertex in &mut self.vertices {
            vertex.color = color;
        }
        self.inside = [color.r, color.g, color.b];
        self.opaque = is_opaque(&self.vertices);
        self
    }

    /// The same triangles in the same order, each with three vertices of its own that have the triangle's normal: what
    /// [`Shading::Flat`] needs. A triangle without area gets +z.
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

    /// The same with its triangles submitted in another order, which the seed decides. Nothing else changes.
    #[must_use]
    pub fn shuffled(&self, seed: u64) -> Self {
        let mut mesh = self.clone();
        Chance::new(seed).shuffle(&mut mesh.triangles);
        mesh
    }

    /// Takes out the triangles that cover nothing and says how many they were.
    pub(super) fn drop_degenerate(&mut self) -> usize {
        let before = self.triangles.len();
        let vertices = &self.vertices;
        self.triangles.retain(|triangle| {
            !normals::is_degenerate(triangle.map(|corner| vertices[corner as usize].position))
        });
        before - self.triangles.len()
    }
}

/// How much memory so many take, in bytes.
pub(super) fn bytes(vertices: u64, triangles: u64) -> u64 {
    let of_vertices = vertices.saturating_mul(size_of::<Vertex>() as u64);
    of_vertices.saturating_add(triangles.saturating_mul(size_of::<[u32; 3]>() as u64))
}

/// Whether nothing shines through any of the vertices.
fn is_opaque(vertices: &[Vertex]) -> bool {
    vertices.iter().all(|vertex| vertex.color.a == 1.0)
}
