//! The box that is drawn for a volume.

use glam::{DVec3, Vec3};

use crate::fragment::Rgba;
use crate::scene::{Mesh, Vertex, Volume};

/// The box around a volume, with its faces turned outwards.
pub(super) fn proxy(volume: &Volume) -> Mesh {
    // Corners by their bits: 1 for the end of x, 2 of y, 4 of z. Counterclockwise, seen from outside.
    const FACES: [[u32; 4]; 6] = [
        [0, 4, 6, 2],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 2, 3, 1],
        [4, 5, 7, 6],
    ];
    let corner = |position: DVec3| Vertex {
        position,
        normal: Vec3::ZERO,
        color: Rgba::default(),
    };
    let mirrored = volume.index_to_world().matrix3.determinant() < 0.0;
    let triangles = FACES.iter().flat_map(|&[a, b, c, d]| {
        if mirrored {
            [[a, c, b], [a, d, c]]
        } else {
            [[a, b, c], [a, c, d]]
        }
    });
    Mesh::new(
        volume.name.clone(),
        volume.corners().map(corner).to_vec(),
        triangles.collect(),
    )
}
