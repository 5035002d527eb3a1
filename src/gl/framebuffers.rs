//! Framebuffers, into which listings draw.

use glow::HasContext;

use super::machine::GlMachine;
use super::making::{expect_no_error, named};
use super::texture::Texture;
use crate::error::{Error, Result};
use crate::steps::{Map, Target};

/// OpenGL 3.0 and later have at least so many colour attachments.
const MOST_COLORS: usize = 8;

impl GlMachine<'_> {
    /// Makes a framebuffer that draws into these maps.
    ///
    /// # Errors
    /// If a map is missing, or the driver does not support the combination.
    pub fn target(&mut self, target: Target, color: Option<Map>, depth: Option<Map>) -> Result<()> {
        self.target_of(target, color.as_slice(), depth)
    }

    /// The same with as many color maps as there are, the first for the shaders' location 0.
    ///
    /// # Errors
    /// As [`target`](Self::target).
    ///
    /// # Panics
    /// With more than eight.
    pub fn target_of(&mut self, target: Target, colors: &[Map], depth: Option<Map>) -> Result<()> {
        self.bind_framebuffer(target)?;
        let gl = self.context.glow();
        let texture = |map: Option<Map>| map.map(|map| self.texture(map)).transpose();
        let attachments: Vec<u32> = (glow::COLOR_ATTACHMENT0..).take(MOST_COLORS).collect();
        let depth_texture = texture(depth)?;
        let depth_attachment = depth_attachment(depth_texture);
        // The framebuffer may have had more color maps before. The others are detached.
        for (number, &attachment) in attachments.iter().enumerate() {
            let raw = texture(colors.get(number).copied())?.map(|texture| texture.raw);
            // SAFETY: the framebuffer is bound, and the texture exists or is none.
            unsafe {
                gl.framebuffer_texture_2d(glow::FRAMEBUFFER, attachment, glow::TEXTURE_2D, raw, 0)
            };
        }
        // SAFETY: as above; there are at most eight colours.
        unsafe {
            let raw = depth_texture.map(|texture| texture.raw);
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
    pub fn copy_to_window(&mut self, target: Target) -> Result<()> {
        let Some(&framebuffer) = self.framebuffers.get(&target) else {
            return Err(Error::usage(
                "there is no image to show yet",
                "render one first",
            ));
        };
        let _visit = self.context.visit()?;
        let gl = self.context.glow();
        let [width, height] = self.size.map(|side| side as i32);
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

    pub(super) fn bind_framebuffer(&mut self, target: Target) -> Result<()> {
        let gl = self.context.glow();
        let framebuffer = match self.framebuffers.get(&target) {
            Some(framebuffer) => *framebuffer,
            None => {
                // SAFETY: the context is current.
                let made = named("framebuffer", unsafe { gl.create_framebuffer() })?;
                self.framebuffers.insert(target, made);
                made
            }
        };
        // SAFETY: the framebuffer is the machine's own.
        unsafe { gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer)) };
        Ok(())
    }
}

/// The attachment of a depth map. A format without a stencil is attached as the depth alone.
pub(super) fn depth_attachment(texture: Option<Texture>) -> u32 {
    match texture {
        Some(texture) if !texture.format.has_stencil() => glow::DEPTH_ATTACHMENT,
        _ => glow::DEPTH_STENCIL_ATTACHMENT,
    }
}
