//! Buffers that a fragment shader reads and writes in the order of submission: how a driver offers them.

use crate::error::{Error, Result};
use crate::gl::Driver;

/// The extension by which a shader reads the framebuffer.
pub(super) const FETCH: &str = "GL_EXT_shader_framebuffer_fetch";
/// The extension by which the fragments of a pixel take their turns with images.
pub(super) const INTERLOCK: &str = "GL_ARB_fragment_shader_interlock";

/// The way in which a shader accesses the buffers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BufferAccess {
    /// By framebuffer fetch if the driver has it, otherwise by interlocked images.
    #[default]
    Best,
    /// By images in any case. Without an interlock, the order of submission is not guaranteed, but llvmpipe keeps it.
    Images,
}

impl BufferAccess {
    /// Whether it is by images, with this driver.
    ///
    /// # Errors
    /// If the driver has neither extension. `instead` says which method needs none.
    pub(super) fn is_by_images(self, driver: &Driver, instead: &str) -> Result<bool> {
        match self {
            Self::Images => Ok(true),
            Self::Best if driver.has(FETCH) => Ok(false),
            Self::Best if driver.has(INTERLOCK) => Ok(true),
            Self::Best => Err(Error::Driver {
                what: format!(
                    "this driver's fragments have no buffers that they read and write in order: it has neither {FETCH} \
                     nor {INTERLOCK}"
                ),
                remedy: format!(
                    "Mesa's llvmpipe has the first, NVIDIA's and Intel's drivers have the second; {instead}"
                ),
            }),
        }
    }
}
