//! Surfaces made of a grid of cells.

use crate::scene::mesh::{Mesh, Vertex};

/// A surface over a grid: its numbers of cells along u and v, and whether u or v is closed, so that it ends where it
/// starts.
pub(super) struct Grid {
    pub(super) cells: [u32; 2],
    /// Whether u and v are closed. A closed direction has no vertices of its own at its end.
    pub(super) closed: [bool; 2],
}

impl Grid {
    /// A grid that is closed in neither direction.
    pub(super) fn open(u: u32, v: u32) -> Self {
        Self {
            cells: [u, v],
            closed: [false; 2],
        }
    }

    /// The number of triangles, two per cell. It saturates, because it is asked for before the number is known to be
    /// small.
    pub(super) fn triangle_count(&self) -> u64 {
        (2 * u64::from(self.cells[0])).saturating_mul(u64::from(self.cells[1]))
    }

    /// The number of vertices. A closed direction has one row less. It saturates for the same reason.
    pub(super) fn vertex_count(&self) -> u64 {
        let [u, v] = [0, 1].map(|i| u64::from(self.cells[i]) + u64::from(!self.closed[i]));
        u.saturating_mul(v)
    }

    /// Adds the surface to a mesh. `vertex` makes each vertex from its u and v, 0 to 1. Triangles are counter-clockwise
    /// for an eye on the side to which (along u) x (along v) points.
    pub(super) fn add_to(&self, mesh: &mut Mesh, vertex: impl Fn(f64, f64) -> Vertex) {
        let first = mesh.vertices.len() as u32;
        let [columns, rows] = self.cells;
        let width = columns + u32::from(!self.closed[0]);
        let height = rows + u32::from(!self.closed[1]);
        for j in 0..height {
            let v = f64::from(j) / f64::from(rows);
            let row = (0..width).map(|i| vertex(f64::from(i) / f64::from(columns), v));
            mesh.vertices.extend(row);
        }
        let at = |i, j| first + j % height * width + i % width;
        for j in 0..rows {
            for i in 0..columns {
                let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                mesh.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
}
