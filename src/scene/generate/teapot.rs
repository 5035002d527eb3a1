//! The Utah teapot from its 32 Bezier patches.

use glam::{DVec3, dvec3};

use super::grid::Grid;
use super::limits::{count_within, few_enough};
use super::teapot_patches::{HALVES, Patch, QUARTERS};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::{Mesh, Vertex};

/// The teapot in its published size. It stands on y = 0, is 3.15 high, and has its spout at +x. The spout is open, and
/// so is the gap between lid and rim. Body, handle and spout go through each other. Two-sided shading shows the inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Teapot {
    /// The number of cells along each edge of a patch, 1 to 559.
    pub cells: u32,
}

impl Default for Teapot {
    /// A teapot of 6320 triangles.
    fn default() -> Self {
        Self { cells: 10 }
    }
}

/// The teapot. It has 64 `cells`² triangles, less 8 `cells` that vanish at the poles. With one cell, 4 more vanish at
/// the spout's lip, because their corners are on one line. Normals are those of the patches.
///
/// # Errors
/// `cells` is out of its range.
pub fn teapot(parameters: &Teapot) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Teapot {
    fn check(&self) -> Result<(), Refusal> {
        count_within("cells", self.cells, [1, u32::MAX])?;
        few_enough("cells", self.triangle_count())
    }

    fn triangle_count(&self) -> u64 {
        Grid::open(self.cells, self.cells)
            .triangle_count()
            .saturating_mul(32)
    }

    fn vertex_count(&self) -> u64 {
        Grid::open(self.cells, self.cells)
            .vertex_count()
            .saturating_mul(32)
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("teapot", self);
        for patch in patches() {
            Grid::open(self.cells, self.cells).add_to(&mut mesh, |u, v| vertex(&patch, u, v));
        }
        mesh.drop_degenerate();
        mesh.painted(WHITE)
    }
}

/// All 32 patches. (along u) x (along v) points out of the pot.
fn patches() -> impl Iterator<Item = Patch> {
    let quarters = QUARTERS.iter().flat_map(|patch| {
        let opposite = mirrored(&mirrored(patch, 0), 1);
        [*patch, mirrored(patch, 0), opposite, mirrored(patch, 1)]
    });
    let halves = HALVES.iter().flat_map(|patch| [*patch, mirrored(patch, 1)]);
    quarters.chain(halves)
}

/// The mirror image of a patch in an axis. Its rows run the other way, so that its outside stays outside.
fn mirrored(patch: &Patch, axis: usize) -> Patch {
    patch.map(|mut row| {
        row.reverse();
        row.map(|mut point| {
            point[axis] = -point[axis];
            point
        })
    })
}

/// A point of a patch, turned so that y is up.
fn vertex(patch: &Patch, u: f64, v: f64) -> Vertex {
    // Rounded to 32 bits, so that the corners of neighbouring patches, and all corners at a pole, coincide to the last
    // bit.
    let upright = |point: DVec3| dvec3(point.x, point.z, -point.y).as_vec3();
    Vertex {
        position: upright(sum(patch, weights(u), weights(v))).as_dvec3(),
        normal: upright(normal(patch, u, v)),
        ..Vertex::default()
    }
}

/// The unit normal. At a pole a whole row of control points is one point, so the derivative along u is 0. Just beside
/// the pole it is the mixed derivative times the distance, which gives the limit of the normal.
fn normal(patch: &Patch, u: f64, v: f64) -> DVec3 {
    let along_u = sum(patch, slopes(u), weights(v));
    let along_v = sum(patch, weights(u), slopes(v));
    // The teapot's lengths are around 1. So this is far above the rounding of derivatives, and far below all
    // derivatives that are not 0.
    if along_u.length() > 1e-9 {
        return along_u.cross(along_v).normalize();
    }
    let mixed = sum(patch, slopes(u), slopes(v));
    let beside = if v < 0.5 { mixed } else { -mixed };
    beside.cross(along_v).normalize()
}

/// The sum of the control points, weighted along u (within a row) and along v (from row to row).
fn sum(patch: &Patch, along_u: [f64; 4], along_v: [f64; 4]) -> DVec3 {
    let rows = patch.iter().zip(along_v);
    let points = rows.flat_map(|(row, by_v)| {
        let points = row.iter().zip(along_u);
        points.map(move |(&[x, y, z], by_u)| {
            dvec3(f64::from(x), f64::from(y), f64::from(z)) * (by_u * by_v)
        })
    });
    points.sum()
}

/// The cubic Bernstein polynomials.
fn weights(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

/// The derivatives of the cubic Bernstein polynomials.
fn slopes(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [
        -3.0 * s * s,
        3.0 * s * (s - 2.0 * t),
        3.0 * t * (2.0 * s - t),
        3.0 * t * t,
    ]
}
