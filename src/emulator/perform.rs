//! The effect of each call.

use super::color::{self, Texel};
use super::depth;
use super::machine::Emulator;
use super::place::write_masked;
use super::shaders::program;
use crate::error::{Error, Result};
use crate::steps::{Buffers, Call, Format, Machine, Map, Query, Target, Workspace};

impl Machine for Emulator {
    fn perform(&mut self, call: &Call) -> Result<()> {
        if self.state.set(call) {
            return Ok(());
        }
        let is_known = match *call {
            Call::Clear { mask } => return self.clear(mask),
            Call::ClearFloats { drawbuffer, value } => {
                return self.clear_buffer(drawbuffer, Texel::Color(value));
            }
            Call::ClearIntegers { drawbuffer } => {
                return self.clear_buffer(drawbuffer, Texel::Integers([0; 4]));
            }
            Call::SamplerCompareFunc { func } => {
                self.settings.compare_func = func;
                true
            }
            Call::ActiveTexture { unit } => self.maps.activate(unit),
            Call::BindTexture { texture } => return self.maps.bind_texture(texture),
            Call::BindImage { unit, texture } => self.maps.bind_image(unit, texture)?,
            // A pixel's part of a buffer is kept with the pixel, and every write is seen at once.
            Call::BindStorage { .. } | Call::MemoryBarrier => true,
            Call::UseProgram { program: shader } => {
                program(shader)?;
                self.program = Some(shader);
                true
            }
            Call::UseProgramOfSize {
                program: shader,
                size,
            } => {
                program(shader)?;
                self.program = Some(shader);
                self.settings.size = size.known()?;
                true
            }
            Call::BindFramebuffer { framebuffer } => {
                self.maps.target = Some(framebuffer);
                true
            }
            Call::AttachColor { texture } => return self.maps.attach_color(texture),
            Call::AttachDepth { texture } => return self.maps.attach_depth(texture),
            Call::BeginQuery { query } => {
                self.queries.insert(query, 0);
                self.counting = Some(query);
                true
            }
            Call::EndQuery { .. } => {
                self.counting = None;
                true
            }
            Call::CopyImage { from, to } => return self.maps.copy(from, to),
            Call::Swap { a, b } => return self.maps.swap(a, b),
            Call::Draw { objects } => return self.draw(objects),
            _ => false,
        };
        if is_known {
            return Ok(());
        }
        Err(Error::CannotPerform {
            machine: "the emulated pixel",
            call: call.to_string(),
            why: "it leaves that out",
            remedy: "its module says what else it leaves out; a GlMachine performs every call",
        })
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.queries.get(&query).copied().ok_or_else(|| {
            let what = format!("the listing asks the query '{}' before it is made", query.0);
            Error::out_of_order(what, "glBeginQuery and glEndQuery come first")
        })
    }
}

impl Workspace for Emulator {
    fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        self.maps.allocate(map, format);
        Ok(())
    }

    fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        self.maps.attach(target, colors, depth)
    }
}

impl Emulator {
    fn clear(&mut self, mask: Buffers) -> Result<()> {
        let attached = self.maps.attached()?;
        if mask.color {
            for number in 0..attached.colors.len() as u32 {
                self.clear_buffer(number, Texel::Color(self.state.clear_color))?;
            }
        }
        let Some(plane) = attached.depth else {
            return Ok(());
        };
        let format = self.maps.planes[plane].format;
        let depth = depth::stored(format, self.state.clear_depth as f32);
        let clears_depth = mask.depth && self.state.depth_mask;
        let stencil = self.state.clear_stencil as u8;
        let stencil_mask = match mask.stencil && format.has_stencil() {
            true => self.state.stencil_mask as u8,
            false => 0,
        };
        for pixel in 0..self.pixels.len() {
            if !self.is_in_band(pixel) {
                continue;
            }
            let plane = &mut self.maps.planes[plane];
            if clears_depth {
                plane.depths[pixel] = depth;
            }
            let here = &mut plane.stencils[pixel];
            *here = (*here & !stencil_mask) | (stencil & stencil_mask);
        }
        Ok(())
    }

    /// Clears one color map of the framebuffer, if it has so many. What is of another kind than the map is left as it is;
    /// OpenGL leaves that open.
    fn clear_buffer(&mut self, number: u32, value: Texel) -> Result<()> {
        let attached = self.maps.attached()?;
        let Some(&plane) = attached.colors.get(number as usize) else {
            return Ok(());
        };
        let mask = self.state.buffers[number as usize].color_mask;
        for pixel in 0..self.pixels.len() {
            if !self.is_in_band(pixel) {
                continue;
            }
            let plane = &mut self.maps.planes[plane];
            let format = plane.format;
            let mut texel = plane.texel(pixel);
            match (&mut texel, value) {
                (Texel::Color(here), Texel::Color(color)) => {
                    write_masked(here, color::stored(format, color), mask);
                }
                (Texel::Integers(here), Texel::Integers(new)) => {
                    write_masked(here, color::stored_integers(format, new), mask);
                }
                _ => {}
            }
            plane.set(pixel, texel);
        }
        Ok(())
    }
}
