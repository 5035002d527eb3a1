//! The calls that name one of a framebuffer's draw buffers.

use glow::HasContext;

use super::constants::blend_factor;
use super::machine::GlMachine;
use crate::error::Result;
use crate::steps::{BlendEquation, DrawBufferCall};

impl GlMachine<'_> {
    /// Does something whose draws are not the method's: they are left out of [`counts`](Self::counts).
    ///
    /// # Errors
    /// Those of `work`.
    pub fn aside<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let counts = self.counts;
        let result = work(self);
        self.counts = counts;
        result
    }

    pub(super) fn draw_buffer(&mut self, call: &DrawBufferCall) {
        let gl = self.context.glow();
        // SAFETY: the context is current, and every constant comes from an enum of OpenGL's own.
        unsafe {
            match *call {
                DrawBufferCall::BlendEquation { buf, mode } => {
                    let mode = match mode {
                        BlendEquation::FuncAdd => glow::FUNC_ADD,
                        BlendEquation::Max => glow::MAX,
                    };
                    gl.blend_equation_draw_buffer(buf, mode);
                }
                DrawBufferCall::BlendFunc { buf, src, dst } => {
                    gl.blend_func_draw_buffer(buf, blend_factor(src), blend_factor(dst));
                }
                DrawBufferCall::Clear { drawbuffer, value } => {
                    gl.clear_buffer_f32_slice(glow::COLOR, drawbuffer, &value);
                }
            }
        }
    }
}
