//! A ground plane.

use glam::Vec3;

use super::grid::Grid;
use super::limits::{LENGTH, all_within, count_within, few_enough};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::{Mesh, Vertex};

/// A rectangle at y = 0, centred on the origin, facing +y.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    /// The extent along x and z, 1e-6 to 1e6.
    pub size: [f32; 2],
    /// The number of cells along each edge, 1 to 3162. A cell has two triangles.
    pub cells: u32,
}

impl Default for Plane {
    /// A plane of 10 by 10, of one cell.
    fn default() -> Self {
        Self {
            size: [10.0, 10.0],
            cells: 1,
        }
    }
}

/// A ground plane.
///
/// # Errors
/// A parameter is out of its range.
pub fn plane(parameters: &Plane) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Plane {
    fn check(&self) -> Result<(), Refusal> {
        all_within("size", &self.size, LENGTH)?;
        count_within("cells", self.cells, [1, u32::MAX])?;
        few_enough("cells", self.triangle_count())
    }

    fn triangle_count(&self) -> u64 {
        Grid::open(self.cells, self.cells).triangle_count()
    }

    fn vertex_count(&self) -> u64 {
        Grid::open(self.cells, self.cells).vertex_count()
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("plane", self);
        let [width, depth] = self.size;
        Grid::open(self.cells, self.cells).add_to(&mut mesh, |u, v| Vertex {
            position: Vec3::new(width * (u as f32 - 0.5), 0.0, depth * (0.5 - v as f32)).as_dvec3(),
            normal: Vec3::Y,
            ..Vertex::default()
        });
        mesh.painted(WHITE)
    }
}
