//! Closed tubes around lines.

use glam::DVec3;

use super::flow::around;
use crate::scene::mesh::{Mesh, Vertex};

/// A ring of a tube.
#[derive(Clone, Copy)]
pub(super) struct Ring {
    pub(super) centre: DVec3,
    pub(super) radius: f64,
}

/// The number of triangles of a tube.
pub(super) fn triangles_of(rings: u64, sides: u64) -> u64 {
    2 * sides * rings.max(1)
}

/// The number of vertices of a tube: those of its rings, and one more at each end.
pub(super) fn vertices_of(rings: u64, sides: u64) -> u64 {
    sides * rings + 2
}

/// Adds a tube through two or more rings. Fans close it, to a point before the first ring and to a point after the last
/// one. Every edge belongs to two triangles. Triangles are counter-clockwise as seen from outside.
pub(super) fn add(mesh: &mut Mesh, rings: &[Ring], [start, end]: [DVec3; 2], sides: u32) {
    let first = mesh.vertices.len() as u32;
    // Where two rings share a centre, as at an arrow's neck, the direction of the whole line is taken.
    let whole = (end - start).normalize_or(DVec3::Z);
    let tangent = |n: usize| {
        let (before, after) = (n.saturating_sub(1), (n + 1).min(rings.len() - 1));
        (rings[after].centre - rings[before].centre).normalize_or(whole)
    };
    let mut right = tangent(0).any_orthonormal_vector();
    for (n, ring) in rings.iter().enumerate() {
        let along = tangent(n);
        // The frame is carried along the line, so that the tube does not twist.
        right = (right - along * right.dot(along)).normalize_or(along.any_orthonormal_vector());
        let frame = [right, along.cross(right)];
        mesh.vertices.extend((0..sides).map(|side| {
            let outwards = around(frame, f64::from(side) / f64::from(sides));
            vertex(ring.centre + outwards * ring.radius, outwards)
        }));
    }
    let last = rings.len() as u32 - 1;
    let at = |ring: u32, side: u32| first + ring * sides + side % sides;
    for ring in 0..last {
        for side in 0..sides {
            let [a, b] = [at(ring, side), at(ring, side + 1)];
            let [c, d] = [at(ring + 1, side + 1), at(ring + 1, side)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let caps = mesh.vertices.len() as u32;
    mesh.vertices.push(vertex(start, -tangent(0)));
    mesh.vertices.push(vertex(end, tangent(last as usize)));
    for side in 0..sides {
        mesh.triangles.push([caps, at(0, side + 1), at(0, side)]);
        let [a, b] = [at(last, side), at(last, side + 1)];
        mesh.triangles.push([caps + 1, a, b]);
    }
}

fn vertex(position: DVec3, normal: DVec3) -> Vertex {
    Vertex {
        position,
        normal: normal.as_vec3(),
        ..Vertex::default()
    }
}
