//! Moving meshes and volumes.

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::mesh::Mesh;

/// A transform that first scales, then rotates about the origin, then moves. The default changes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// The translation, in the scene's units.
    pub translate: DVec3,
    /// The axis of the rotation, of any length but zero.
    pub axis: DVec3,
    /// The angle of the rotation in degrees, counter-clockwise for an eye that the axis points at.
    pub degrees: f64,
    /// Factors along x, y and z, none of them zero. An odd number of negative factors mirrors. The outside of a mesh
    /// stays outside.
    pub scale: DVec3,
}

impl Default for Transform {
    fn default() -> Self {
        Self {
            translate: DVec3::ZERO,
            axis: DVec3::Y,
            degrees: 0.0,
            scale: DVec3::ONE,
        }
    }
}

impl Transform {
    /// The transform as an affine map.
    pub fn to_affine(&self) -> DAffine3 {
        DAffine3::from_scale_rotation_translation(self.scale, self.rotation(), self.translate)
    }

    fn rotation(&self) -> DQuat {
        let axis = self.axis.normalize_or(DVec3::Y);
        DQuat::from_axis_angle(axis, self.degrees.to_radians())
    }
}

impl Mesh {
    /// The transformed mesh. A driver cannot draw a coordinate beyond the range of f32, see [`Mesh::is_finite`].
    #[must_use]
    pub fn transformed(mut self, transform: &Transform) -> Self {
        if *transform == Transform::default() {
            return self;
        }
        let to_world = transform.to_affine();
        // Normals take the inverse scale, so that they stay perpendicular to what they stand on.
        let for_normals =
            DMat3::from_quat(transform.rotation()) * DMat3::from_diagonal(transform.scale.recip());
        for vertex in &mut self.vertices {
            let position = to_world.transform_point3(vertex.position);
            let normal = for_normals * vertex.normal.as_dvec3();
            vertex.position = position;
            vertex.normal = normal.normalize_or(DVec3::Z).as_vec3();
        }
        if transform.scale.element_product() < 0.0 {
            for triangle in &mut self.triangles {
                triangle.swap(1, 2);
            }
        }
        self
    }

    /// Whether every position and normal is finite, in 32 bits as in 64.
    pub fn is_finite(&self) -> bool {
        self.vertices
            .iter()
            .all(|vertex| vertex.position.as_vec3().is_finite() && vertex.normal.is_finite())
    }
}
