//! Normals from positions, in f64.

use glam::{DVec3, Vec3};

/// One normal per position: those of the triangles around it, weighted by their areas, so that a sliver counts little
/// and a triangle without area nothing. Unit length; +z where there is nothing to go by.
pub(super) fn smooth(positions: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for triangle in triangles {
        let doubled_area = cross(triangle.map(|corner| positions[corner as usize]));
        for &corner in triangle {
            sums[corner as usize] += doubled_area;
        }
    }
    sums.into_iter().map(unit).collect()
}

/// A triangle's own normal; +z if it has no area.
pub(super) fn face(corners: [DVec3; 3]) -> Vec3 {
    unit(cross(corners))
}

/// Whether a triangle covers nothing: its corners are on one line, or coincide. Exact for corners that are f32 within a
/// factor of 2^28 of each other, where neither the differences nor the products are rounded in f64.
pub(super) fn is_degenerate(corners: [DVec3; 3]) -> bool {
    cross(corners) == DVec3::ZERO
}

/// Twice the area, along the normal.
fn cross([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

fn unit(vector: DVec3) -> Vec3 {
    vector.normalize_or(DVec3::Z).as_vec3()
}
