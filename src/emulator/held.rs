//! What a pixel of the bound framebuffer holds, as reading it back gives it.

use super::depth::read_back;
use super::machine::Emulator;
use crate::error::Result;
use crate::steps::Held;

impl Emulator {
    /// The values that a pixel of the bound framebuffer holds.
    ///
    /// # Errors
    /// If no framebuffer is bound.
    pub fn held(&self, pixel: usize) -> Result<Held> {
        let attached = self.maps.attached()?;
        let planes = &self.maps.planes;
        let depth = attached.depth.map(|plane| &planes[plane]);
        let with_stencil = depth.filter(|plane| plane.format.has_stencil());
        let colors = attached.colors.iter();
        let colors = colors.map(|&plane| planes[plane].texel(pixel));
        Ok(Held {
            depth: depth.map(|plane| read_back(plane.format, plane.depths[pixel])),
            stencil: with_stencil.map(|plane| plane.stencils[pixel]),
            colors: colors.collect(),
        })
    }
}
