//! Normals from positions, in f64.

use glam::{DVec3, Vec3};

/// One normal of unit length per position: the mean of the normals of the triangles around it, weighted by their areas.
/// So a sliver counts little, and a triangle without area does not count. A position without any such triangle gets +z.
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

/// The normal of a triangle, or +z if the triangle has no area.
pub(super) fn face(corners: [DVec3; 3]) -> Vec3 {
    unit(cross(corners))
}

/// Whether a triangle covers nothing because its corners are on one line or coincide. The answer is exact for f32
/// corners within a factor of 2^28 of each other, for which f64 rounds neither the differences nor the products.
pub(super) fn is_degenerate(corners: [DVec3; 3]) -> bool {
    cross(corners) == DVec3::ZERO
}

/// A vector along the normal whose length is twice the area.
fn cross([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

fn unit(vector: DVec3) -> Vec3 {
    vector.normalize_or(DVec3::Z).as_vec3()
}
