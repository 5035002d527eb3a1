//! The machine under the eyes of a witness.

use glow::HasContext;

use super::framebuffers::MOST_COLORS;
use super::machine::GlMachine;
use super::pixel_store::PixelStore;
use super::witness::{Seen, Watch, Witness};
use crate::error::Result;
use crate::steps::{Call, Held, Texel};

impl GlMachine<'_> {
    /// Shows its work to a witness from now on, or to nobody.
    pub fn set_witness(&mut self, witness: Option<Box<dyn Witness>>) {
        self.watch = Watch(witness);
    }

    /// Does work that its witness does not see.
    pub(super) fn unwatched<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let watch = std::mem::take(&mut self.watch);
        let result = work(self);
        self.watch = watch;
        result
    }

    pub(super) fn show(&mut self, call: &Call) -> Result<()> {
        let Some(mut witness) = self.watch.0.take() else {
            return Ok(());
        };
        let seen = Seen {
            program: self.programs.current_name(),
            size: self.size(),
            held: &|pixel| self.held(pixel),
            counts: &|map| self.read_counts(map),
        };
        let done = witness.performed(call, &seen);
        self.watch.0 = Some(witness);
        done
    }

    /// The values that a pixel of the bound framebuffer holds. The pixel is in column `x` from the left and row `y` from the
    /// bottom.
    fn held(&self, [x, y]: [u32; 2]) -> Held {
        let gl = self.context.glow();
        let _tight = PixelStore::own(self.context);
        // SAFETY: the context is current. Only what is attached is asked and read, one texel of the format and type that
        // its slice has.
        unsafe {
            let about = |attachment, parameter| {
                gl.get_framebuffer_attachment_parameter_i32(
                    glow::FRAMEBUFFER,
                    attachment,
                    parameter,
                ) as u32
            };
            let is_attached =
                |at| about(at, glow::FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == glow::TEXTURE;
            let read = |format, kind, into: &mut [u8]| {
                let into = glow::PixelPackData::Slice(Some(into));
                gl.read_pixels(x as i32, y as i32, 1, 1, format, kind, into);
            };
            let mut held = Held::default();
            if is_attached(glow::DEPTH_ATTACHMENT) {
                let mut depth = [0.0_f32];
                let into = bytemuck::cast_slice_mut(&mut depth);
                read(glow::DEPTH_COMPONENT, glow::FLOAT, into);
                held.depth = Some(depth[0]);
            }
            if is_attached(glow::STENCIL_ATTACHMENT) {
                let mut stencil = [0];
                read(glow::STENCIL_INDEX, glow::UNSIGNED_BYTE, &mut stencil);
                held.stencil = Some(stencil[0]);
            }
            let colors = (glow::COLOR_ATTACHMENT0..).take(MOST_COLORS);
            for color in colors.filter(|&color| is_attached(color)) {
                gl.read_buffer(color);
                let kind = about(color, glow::FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
                held.colors.push(match kind {
                    glow::UNSIGNED_INT => {
                        let mut texel = [0_u32; 4];
                        let into = bytemuck::cast_slice_mut(&mut texel);
                        read(glow::RGBA_INTEGER, glow::UNSIGNED_INT, into);
                        Texel::Integers(texel)
                    }
                    _ => {
                        let mut texel = [0.0_f32; 4];
                        read(
                            glow::RGBA,
                            glow::FLOAT,
                            bytemuck::cast_slice_mut(&mut texel),
                        );
                        Texel::Color(texel)
                    }
                });
                gl.read_buffer(glow::COLOR_ATTACHMENT0);
            }
            held
        }
    }
}
