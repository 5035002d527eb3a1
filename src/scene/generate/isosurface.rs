//! Isosurfaces: the surfaces on which a volume has a given value.
//!
//! They are made by marching tetrahedra. Every cell of the lattice is cut into the six tetrahedra around its diagonal
//! from (0, 0, 0) to (1, 1, 1), and every tetrahedron with samples on both sides of the value gives one triangle or
//! two. Neighbouring cells cut their common face alike, and a tetrahedron has no ambiguous case, so there are no
//! cracks. The surface is closed except where it leaves the proxy box and where it meets empty cells, which have no
//! value and no surface.
//!
//! The code is our own because no crate was found that gives as much. In mcubes triangles share no corner, so that
//! nothing is closed. fast-surface-nets puts its corners beside the surface. ferreus_rmt follows the surface from
//! points that the caller has to know. isosurface has stopped at an alpha version. isomesh says of itself that nobody
//! has reviewed it.

use std::collections::HashMap;

use glam::DVec3;

use super::limits::{few_enough, refusal};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::{self, Mesh, Vertex};
use crate::scene::volume::Volume;

/// The surface on which a volume has a given value.
#[derive(Clone, Copy, Debug)]
pub struct Isosurface<'v> {
    /// The volume.
    pub volume: &'v Volume,
    /// The value, greater than the volume's least and at most its greatest.
    pub value: f32,
}

/// An isosurface. Values are lower on its outside. Its normals are those of the gradient.
///
/// # Errors
/// No sample is lower than the value or none reaches it, or the surface has too many triangles.
pub fn isosurface(parameters: &Isosurface) -> Result<Mesh> {
    checked(parameters)
}

/// A cell's six tetrahedra, and whether each is right-handed. A tetrahedron is a way from corner 0 to corner 7 along
/// one axis after the other. Bit 0 of a corner's number stands for x.
const TETRAHEDRA: [([usize; 4], bool); 6] = [
    ([0, 1, 3, 7], true),
    ([0, 2, 6, 7], true),
    ([0, 4, 5, 7], true),
    ([0, 2, 3, 7], false),
    ([0, 4, 6, 7], false),
    ([0, 1, 5, 7], false),
];

/// The corners of a tetrahedron as an even permutation, indexed by the bits of the corners inside. The corner that is
/// alone inside or outside comes first, or the two that are inside.
const EVEN: [[usize; 4]; 16] = [
    [0, 1, 2, 3],
    [0, 1, 2, 3],
    [1, 0, 3, 2],
    [0, 1, 2, 3],
    [2, 3, 0, 1],
    [0, 2, 3, 1],
    [1, 2, 0, 3],
    [3, 2, 1, 0],
    [3, 2, 1, 0],
    [0, 3, 1, 2],
    [1, 3, 2, 0],
    [2, 3, 0, 1],
    [2, 3, 0, 1],
    [1, 0, 3, 2],
    [0, 1, 2, 3],
    [0, 1, 2, 3],
];

/// An edge of a tetrahedron, as the two corners of the cell at its ends.
type Edge = [usize; 2];

impl Generator for Isosurface<'_> {
    fn check(&self) -> Result<(), Refusal> {
        let samples = self.volume.samples();
        let low = samples.iter().copied().fold(f32::INFINITY, f32::min);
        let high = samples.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        if !(self.value > low && self.value <= high) {
            let what = format!(
                "'{}' has no surface at {}: its values go from {low} to {high}",
                self.volume.name, self.value
            );
            return Err(refusal("value", what, "Give a value between them."));
        }
        few_enough("value", self.triangle_count())
    }

    fn triangle_count(&self) -> u64 {
        let mut triangles = 0;
        self.for_each_triangle(|_, _| triangles += 1);
        triangles
    }

    fn vertex_count(&self) -> u64 {
        let mut vertices = 0;
        self.for_each_crossing(|_, _| vertices += 1);
        vertices
    }

    /// The memory for the mesh and for the table of its edges while it is made. A hash table at its fullest is half
    /// empty.
    fn bytes(&self) -> u64 {
        let known = size_of::<((usize, usize), u32)>() as u64 * 2;
        let vertices = self.vertex_count();
        mesh::bytes(vertices, self.triangle_count()) + vertices * known
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("isosurface", self);
        let mut known: HashMap<(usize, usize), u32> = HashMap::new();
        let mirrored = self.volume.index_to_world().matrix3.determinant() < 0.0;
        self.for_each_triangle(|cell, edges| {
            let mut triangle = edges.map(|[from, to]| {
                // From its lower end, an edge of any cell goes along the axes 1 to 7.
                let first = self.offset(cell) + self.offset(corner([0; 3], from));
                *known.entry((first, from ^ to)).or_insert_with(|| {
                    mesh.vertices.push(self.vertex(cell, [from, to]));
                    (mesh.vertices.len() - 1) as u32
                })
            });
            if mirrored {
                triangle.swap(1, 2);
            }
            mesh.triangles.push(triangle);
        });
        mesh.painted(WHITE)
    }
}

impl Isosurface<'_> {
    /// Calls with every triangle: its cell, and the edges on which its corners lie. Triangles are counter-clockwise as
    /// seen from outside.
    fn for_each_triangle(&self, mut take: impl FnMut([usize; 3], [Edge; 3])) {
        let samples = self.volume.samples();
        let offsets: [usize; 8] = std::array::from_fn(|n| self.offset(corner([0; 3], n)));
        let [nx, ny, nz] = self.volume.dims();
        for z in 0..nz - 1 {
            for y in 0..ny - 1 {
                for x in 0..nx - 1 {
                    let first = self.offset([x, y, z]);
                    let corners = offsets.map(|offset| samples[first + offset]);
                    let inside = corners.map(|sample| sample >= self.value);
                    if inside.iter().all(|&it| it == inside[0])
                        || corners.iter().any(|sample| sample.is_nan())
                    {
                        continue;
                    }
                    for (corners, right_handed) in TETRAHEDRA {
                        cut(corners, right_handed, &inside, |edges| {
                            take([x, y, z], edges);
                        });
                    }
                }
            }
        }
    }

    /// Every edge that the surface crosses, as its lower end and its axes (bit 0 is x). Each such edge has a vertex.
    fn for_each_crossing(&self, mut take: impl FnMut(usize, usize)) {
        let samples = self.volume.samples();
        let [nx, ny, nz] = self.volume.dims();
        for z in 0..nz {
            for y in 0..ny {
                for x in 0..nx {
                    let first = self.offset([x, y, z]);
                    let inside = samples[first] >= self.value;
                    for axes in 1..8 {
                        let [i, j, k] = corner([x, y, z], axes);
                        if i < nx && j < ny && k < nz {
                            let there = samples[self.offset([i, j, k])] >= self.value;
                            if there != inside {
                                take(first, axes);
                            }
                        }
                    }
                }
            }
        }
    }

    fn offset(&self, [x, y, z]: [usize; 3]) -> usize {
        let [nx, ny, _] = self.volume.dims();
        x + nx * (y + ny * z)
    }

    fn vertex(&self, cell: [usize; 3], ends: Edge) -> Vertex {
        let places = ends.map(|end| corner(cell, end));
        let [from, to] = places.map(|place| f64::from(self.volume.samples()[self.offset(place)]));
        let [start, end] = places.map(|place| DVec3::from_array(place.map(|i| i as f64)));
        let index = start.lerp(end, (f64::from(self.value) - from) / (to - from));
        let to_world = self.volume.index_to_world();
        let uphill = self.volume.world_to_index().matrix3.transpose() * self.gradient(cell, index);
        Vertex {
            position: to_world.transform_point3(index),
            normal: (-uphill).normalize_or(DVec3::Z).as_vec3(),
            ..Vertex::default()
        }
    }

    /// The gradient, by central differences over two samples, or, beside empty cells, from the cell that the place is
    /// in.
    fn gradient(&self, cell: [usize; 3], index: DVec3) -> DVec3 {
        let along =
            |axis: DVec3| self.volume.at_index(index + axis) - self.volume.at_index(index - axis);
        let gradient = DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z));
        if gradient.is_nan() {
            return self.gradient_within(cell, index);
        }
        gradient
    }

    /// The derivatives, at a place in a cell, of the trilinear interpolation between its corners.
    fn gradient_within(&self, cell: [usize; 3], index: DVec3) -> DVec3 {
        let first = DVec3::from_array(cell.map(|i| i as f64));
        let part = index - first;
        let mut gradient = DVec3::ZERO;
        for number in 0..8 {
            let sample = f64::from(self.volume.samples()[self.offset(corner(cell, number))]);
            let is_far: [bool; 3] = std::array::from_fn(|axis| number >> axis & 1 == 1);
            let weight = |axis: usize| {
                if is_far[axis] {
                    part[axis]
                } else {
                    1.0 - part[axis]
                }
            };
            for axis in 0..3 {
                let sign = if is_far[axis] { 1.0 } else { -1.0 };
                let others = weight((axis + 1) % 3) * weight((axis + 2) % 3);
                gradient[axis] += sign * others * sample;
            }
        }
        gradient
    }
}

fn corner([x, y, z]: [usize; 3], number: usize) -> [usize; 3] {
    [x + (number & 1), y + (number >> 1 & 1), z + (number >> 2)]
}

/// The triangles of one tetrahedron.
fn cut(
    corners: [usize; 4],
    right_handed: bool,
    inside: &[bool; 8],
    mut take: impl FnMut([Edge; 3]),
) {
    let bits = (0..4).fold(0, |bits, n| bits | usize::from(inside[corners[n]]) << n);
    let [a, b, c, d] = EVEN[bits].map(|n| corners[n]);
    // The lower end comes first. It is the one with fewer bits, because all corners lie on one way from 0 to 7.
    let edge = |i: usize, j: usize| [i.min(j), i.max(j)];
    let mut turned = |[p, q, r]: [Edge; 3], seen_from_outside: bool| {
        take(if seen_from_outside == right_handed {
            [p, q, r]
        } else {
            [p, r, q]
        });
    };
    match bits.count_ones() {
        1 => turned([edge(a, b), edge(a, c), edge(a, d)], true),
        2 => {
            let [ac, ad, bd, bc] = [edge(a, c), edge(a, d), edge(b, d), edge(b, c)];
            turned([ac, ad, bd], true);
            turned([ac, bd, bc], true);
        }
        // The corner that is alone is the first of the permutation here, too.
        3 => turned([edge(a, b), edge(a, c), edge(a, d)], false),
        _ => {}
    }
}
