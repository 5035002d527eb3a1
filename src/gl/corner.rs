//! Vertices as the driver has them.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use glow::HasContext;

use super::bindings::{COLOR, NORMAL, POSITION};
use crate::error::{Error, Result};
use crate::scene::{Mesh, Vertex};

/// A vertex in the driver's form.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Corner {
    position: [f32; 3],
    normal: [f32; 3],
    color: [f32; 4],
}

impl Corner {
    /// Bytes from a corner's beginning to its colour.
    pub(super) const COLOR_OFFSET: usize = std::mem::offset_of!(Self, color);

    fn of(vertex: &Vertex, origin: DVec3) -> Self {
        Self {
            position: (vertex.position - origin).as_vec3().to_array(),
            normal: vertex.normal.to_array(),
            color: vertex.color.to_array(),
        }
    }

    /// # Safety
    /// The context is current, and the buffer of corners is bound, as is the vertex array.
    pub(super) unsafe fn set_attributes(gl: &glow::Context) {
        let stride = size_of::<Self>() as i32;
        for (attribute, components, offset) in [(POSITION, 3, 0), (NORMAL, 3, 12), (COLOR, 4, 24)] {
            // SAFETY: the attributes lie within the stride, as Corner is laid out in C's way.
            unsafe {
                gl.enable_vertex_attrib_array(attribute);
                gl.vertex_attrib_pointer_f32(
                    attribute,
                    components,
                    glow::FLOAT,
                    false,
                    stride,
                    offset,
                );
            }
        }
    }
}

/// The vertices of a mesh, relative to `origin`.
pub(super) fn corners(mesh: &Mesh, origin: DVec3) -> Vec<Corner> {
    let corners = mesh.vertices.iter();
    corners.map(|vertex| Corner::of(vertex, origin)).collect()
}

/// # Errors
/// If a triangle has a corner that is no vertex.
pub(super) fn expect_indices(mesh: &Mesh) -> Result<()> {
    let count = mesh.vertices.len();
    let mut indices = mesh.triangles.as_flattened().iter();
    match indices.find(|&&index| index as usize >= count) {
        None => Ok(()),
        Some(index) => Err(Error::scene(
            format!("mesh '{}' uses vertex {index} of {count}", mesh.name),
            "every index of a triangle must be below the number of vertices",
        )),
    }
}
