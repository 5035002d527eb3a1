//! The state that each draw buffer has separately: blending and the color mask.

use glow::HasContext;

use super::super::context::Context;

/// OpenGL 3.0 and later have at least so many draw buffers, and a machine uses no more.
const DRAW_BUFFERS: u32 = 8;

#[derive(Debug)]
pub(super) struct PerBuffer([Buffer; DRAW_BUFFERS as usize]);

#[derive(Clone, Copy, Debug)]
struct Buffer {
    blends: bool,
    /// Source and destination, of colours, then of alpha.
    factors: [u32; 4],
    /// Of colours and of alpha.
    equations: [u32; 2],
    mask: [bool; 4],
}

impl PerBuffer {
    /// As a fresh context has it.
    pub(super) const fn initial() -> Self {
        Self(
            [Buffer {
                blends: false,
                factors: [glow::ONE, glow::ZERO, glow::ONE, glow::ZERO],
                equations: [glow::FUNC_ADD; 2],
                mask: [true; 4],
            }; DRAW_BUFFERS as usize],
        )
    }

    pub(super) fn read(context: &Context) -> Self {
        let gl = context.glow();
        // SAFETY: the context is current; the mask is four numbers, the others are one each.
        let first_mask = unsafe { gl.get_parameter_bool_array::<4>(glow::COLOR_WRITEMASK) };
        Self(std::array::from_fn(|index| {
            let index = index as u32;
            let number = |name| {
                // SAFETY: as above.
                unsafe { gl.get_parameter_indexed_i32(name, index) as u32 }
            };
            let mask = context.more().four(glow::COLOR_WRITEMASK, index);
            Buffer {
                blends: number(glow::BLEND) != 0,
                factors: [
                    glow::BLEND_SRC_RGB,
                    glow::BLEND_DST_RGB,
                    glow::BLEND_SRC_ALPHA,
                    glow::BLEND_DST_ALPHA,
                ]
                .map(number),
                equations: [glow::BLEND_EQUATION_RGB, glow::BLEND_EQUATION_ALPHA].map(number),
                mask: mask.map_or(first_mask, |mask| mask.map(|channel| channel != 0)),
            }
        }))
    }

    pub(super) fn set(&self, context: &Context) {
        let gl = context.glow();
        for (index, buffer) in (0..).zip(&self.0) {
            let [src_rgb, dst_rgb, src_alpha, dst_alpha] = buffer.factors;
            let [rgb, alpha] = buffer.equations;
            let [r, g, b, a] = buffer.mask;
            // SAFETY: the context is current, and has so many draw buffers; the values are OpenGL's own or what it has
            // answered.
            unsafe {
                if buffer.blends {
                    gl.enable_draw_buffer(glow::BLEND, index);
                } else {
                    gl.disable_draw_buffer(glow::BLEND, index);
                }
                gl.blend_func_separate_draw_buffer(index, src_rgb, dst_rgb, src_alpha, dst_alpha);
                // The equations of KHR_blend_equation_advanced are for both or for none.
                if rgb == alpha {
                    gl.blend_equation_draw_buffer(index, rgb);
                } else {
                    gl.blend_equation_separate_draw_buffer(index, rgb, alpha);
                }
                gl.color_mask_draw_buffer(index, r, g, b, a);
            }
        }
    }
}
