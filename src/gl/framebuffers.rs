//! Framebuffers, into which listings draw.

use std::collections::HashMap;

use glow::HasContext;

use super::context::Context;
use super::making::{expect_no_error, named};
use super::texture::Texture;
use crate::error::{Error, Result};
use crate::steps::Target;

/// OpenGL 3.0 and later have at least so many colour attachments.
pub(super) const MOST_COLORS: usize = 8;

/// The framebuffers of a machine, by name.
#[derive(Debug, Default)]
pub(super) struct Framebuffers(HashMap<Target, glow::Framebuffer>);

impl Framebuffers {
    /// Makes a framebuffer that draws into these textures, the first color for the shaders' location 0. The context is
    /// current, here and below.
    ///
    /// # Errors
    /// If the driver does not take the combination.
    ///
    /// # Panics
    /// With more than eight colors.
    pub(super) fn attach(
        &mut self,
        gl: &glow::Context,
        target: Target,
        colors: &[Texture],
        depth: Option<Texture>,
    ) -> Result<()> {
        self.bind(gl, target)?;
        let attachments: Vec<u32> = (glow::COLOR_ATTACHMENT0..).take(MOST_COLORS).collect();
        let depth_attachment = depth_attachment(depth);
        // The framebuffer may have had more before: the others are attached to nothing.
        for (number, &attachment) in attachments.iter().enumerate() {
            let raw = colors.get(number).map(|texture| texture.raw);
            // SAFETY: the framebuffer is bound, and the texture exists or is none.
            unsafe {
                gl.framebuffer_texture_2d(glow::FRAMEBUFFER, attachment, glow::TEXTURE_2D, raw, 0)
            };
        }
        // SAFETY: as above; there are at most eight colours.
        unsafe {
            let raw = depth.map(|texture| texture.raw);
            gl.framebuffer_texture_2d(
                glow::FRAMEBUFFER,
                depth_attachment,
                glow::TEXTURE_2D,
                raw,
                0,
            );
            gl.draw_buffers(&attachments[..colors.len().max(1)]);
        }
        // SAFETY: the framebuffer is bound.
        match unsafe { gl.check_framebuffer_status(glow::FRAMEBUFFER) } {
            glow::FRAMEBUFFER_COMPLETE => Ok(()),
            // A framebuffer whose depth map the listing will attach has no map yet.
            glow::FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT
                if colors.is_empty() && depth.is_none() =>
            {
                Ok(())
            }
            status => Err(Error::Driver {
                what: format!(
                    "the driver does not draw into the framebuffer '{}' (status 0x{status:X})",
                    target.0
                ),
                remedy:
                    "choose other formats for colour and depth; `onionskin doctor` shows the driver"
                        .into(),
            }),
        }
    }

    /// Copies a framebuffer's colours into the default framebuffer, lower left corner on lower left corner.
    ///
    /// # Errors
    /// If there is no such framebuffer.
    pub(super) fn copy_to_window(
        &self,
        context: &Context,
        target: Target,
        size: [u32; 2],
    ) -> Result<()> {
        let Some(&framebuffer) = self.0.get(&target) else {
            return Err(Error::out_of_order(
                "there is no image to show yet",
                "render one first",
            ));
        };
        let _visit = context.visit()?;
        let gl = context.glow();
        let [width, height] = size.map(|side| side as i32);
        // SAFETY: the context is current, and the framebuffer is the machine's own.
        unsafe {
            // Both would change the copied colours.
            gl.disable_draw_buffer(glow::SCISSOR_TEST, 0);
            gl.disable(glow::FRAMEBUFFER_SRGB);
            gl.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(framebuffer));
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, None);
            let all = glow::COLOR_BUFFER_BIT;
            gl.blit_framebuffer(0, 0, width, height, 0, 0, width, height, all, glow::NEAREST);
        }
        expect_no_error(gl, "when the image is copied into the window's framebuffer")
    }

    /// Binds a framebuffer, which is made when it is first named.
    pub(super) fn bind(&mut self, gl: &glow::Context, target: Target) -> Result<()> {
        let framebuffer = match self.0.get(&target) {
            Some(framebuffer) => *framebuffer,
            None => {
                // SAFETY: the context is current.
                let made = named("framebuffer", unsafe { gl.create_framebuffer() })?;
                self.0.insert(target, made);
                made
            }
        };
        // SAFETY: the framebuffer is the machine's own.
        unsafe { gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer)) };
        Ok(())
    }

    pub(super) fn delete(&mut self, gl: &glow::Context) {
        for (_, framebuffer) in self.0.drain() {
            // SAFETY: the framebuffer is the machine's own and leaves its table here.
            unsafe { gl.delete_framebuffer(framebuffer) };
        }
    }
}

/// The attachment of a depth map. A format without a stencil is attached as the depth alone.
pub(super) fn depth_attachment(texture: Option<Texture>) -> u32 {
    match texture {
        Some(texture) if !texture.format.has_stencil() => glow::DEPTH_ATTACHMENT,
        _ => glow::DEPTH_STENCIL_ATTACHMENT,
    }
}
