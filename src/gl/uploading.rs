//! Uploads that keep the host's bindings, and check that there was enough memory.

use glow::HasContext;

use super::context::Context;
use super::making::allocate;
use crate::error::Result;

/// The bindings that an upload changes.
pub(super) struct Bound<'c> {
    context: &'c Context,
    array: Option<glow::VertexArray>,
    buffer: Option<glow::Buffer>,
}

impl<'c> Bound<'c> {
    pub(super) fn keep(context: &'c Context) -> Result<Self> {
        context.begin_making()?;
        let gl = context.glow();
        // SAFETY: the context is current; both are bindings.
        unsafe {
            Ok(Self {
                context,
                array: gl.get_parameter_vertex_array(glow::VERTEX_ARRAY_BINDING),
                buffer: gl.get_parameter_buffer(glow::ARRAY_BUFFER_BINDING),
            })
        }
    }
}

impl Drop for Bound<'_> {
    fn drop(&mut self) {
        let gl = self.context.glow();
        // SAFETY: as above.
        unsafe {
            gl.bind_vertex_array(self.array);
            gl.bind_buffer(glow::ARRAY_BUFFER, self.buffer);
        }
    }
}

/// Fills the buffer that is bound to `target`, which counts as an upload.
pub(super) fn fill(context: &Context, target: u32, what: &str, bytes: &[u8]) -> Result<()> {
    let gl = context.glow();
    context.count_upload();
    allocate(gl, what, bytes.len() as u64, || {
        // SAFETY: the context is current, and a buffer is bound.
        unsafe { gl.buffer_data_u8_slice(target, bytes, glow::STATIC_DRAW) };
    })
}
