//! The prefix scan that gives each pixel of a DFB its base offset (Maule et al. 2012; Lindholm et al. 2015, section 4),
//! in compute shaders, over any number of pixels.
//!
//! Level 0 holds the pixels' counts. Each number of a higher level is the sum of 64 numbers of the level below. Then,
//! from the top down, each number becomes the sum of those before it.

use glow::HasContext;

use super::bindings;
use super::context::Context;
use super::glsl::Files;
use super::making::Making;
use super::program::{Define, Program};
use super::storage::Storages;
use super::texture::Texture;
use crate::error::Result;
use crate::steps::Storage;

/// The count of numbers of a level whose sum is a number of the next level.
pub(crate) const CHUNK: u32 = 64;
/// Invocations in a work group of `scan_reduce.comp` and `scan_spread.comp`.
const GROUP: u32 = 256;
/// Work group sides of `scan_gather.comp`.
const TILE: u32 = 16;

/// What its shaders are compiled with.
const DEFINES: [Define; 3] = [("CHUNK", CHUNK), ("GROUP", GROUP), ("TILE", TILE)];

/// Levels above the first: 64^6 is more than any image has pixels.
const LEVELS: [Storage; 6] = [
    Storage("scan level 1"),
    Storage("scan level 2"),
    Storage("scan level 3"),
    Storage("scan level 4"),
    Storage("scan level 5"),
    Storage("scan level 6"),
];

/// The scan's programs, linked when one is first asked for.
#[derive(Debug, Default)]
pub(super) struct Scan(Option<Programs>);

#[derive(Debug)]
struct Programs {
    gather: Program,
    reduce: Program,
    spread: Program,
}

/// Bytes of the buffers that a scan of so many numbers needs, the result included.
pub(super) fn scan_bytes(numbers: u64) -> u64 {
    let levels = std::iter::successors(Some(numbers), |&n| {
        (n > 1).then(|| n.div_ceil(u64::from(CHUNK)))
    });
    // A level alone cannot be smaller than what a buffer must have.
    levels.map(|n| (n * 4).max(16)).sum()
}

impl Scan {
    /// Makes `offsets` hold, for each pixel, the sum of the counts of the pixels before it, row by row from the bottom,
    /// modulo 2^32. Changes OpenGL's current program. The context is current.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(super) fn run(
        &mut self,
        context: &Context,
        files: &Files,
        storages: &mut Storages,
        counts: Texture,
        offsets: Storage,
    ) -> Result<()> {
        let gl = context.glow();
        let programs = match self.0.take() {
            Some(programs) => programs,
            None => Programs::new(gl, files)?,
        };
        let programs = self.0.insert(programs);
        let numbers = counts.size[0] * counts.size[1];
        storages.allocate(context, offsets, u64::from(numbers) * 4, None)?;
        // (buffer, how many numbers), from the pixels up to a single number.
        let mut levels = vec![(offsets, numbers)];
        for level in LEVELS {
            let (_, below) = levels[levels.len() - 1];
            if below <= 1 {
                break;
            }
            let here = below.div_ceil(CHUNK);
            storages.allocate(context, level, u64::from(here) * 4, None)?;
            levels.push((level, here));
        }
        programs.gather(gl, storages, counts, offsets)?;
        for pair in levels.windows(2) {
            programs.level(gl, storages, pair[0], pair[1].0, None)?;
        }
        let (top, numbers) = levels[levels.len() - 1];
        programs.level(gl, storages, (top, numbers), top, Some(true))?;
        for pair in levels.windows(2).rev() {
            programs.level(gl, storages, pair[0], pair[1].0, Some(false))?;
        }
        Ok(())
    }

    pub(super) fn delete(&mut self, gl: &glow::Context) {
        if let Some(programs) = self.0.take() {
            for program in [programs.gather, programs.reduce, programs.spread] {
                // SAFETY: the programs are its own.
                unsafe { gl.delete_program(program.raw) };
            }
        }
    }
}

impl Programs {
    fn new(gl: &glow::Context, files: &Files) -> Result<Self> {
        let mut making = Making::new(gl);
        let mut link = |name| Program::link(&mut making, files, &[&[name]], &DEFINES);
        let programs = Self {
            gather: link("a_buffer/scan_gather.comp")?,
            reduce: link("a_buffer/scan_reduce.comp")?,
            spread: link("a_buffer/scan_spread.comp")?,
        };
        making.finish();
        Ok(programs)
    }

    fn gather(
        &self,
        gl: &glow::Context,
        storages: &Storages,
        counts: Texture,
        offsets: Storage,
    ) -> Result<()> {
        let [width, height] = counts.size;
        storages.bind(gl, bindings::LOWER_LEVEL, offsets)?;
        // SAFETY: the program is linked; the shader writes only the numbers that the buffer has room for.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + bindings::SCANNED_COUNTS);
            gl.bind_texture(glow::TEXTURE_2D, Some(counts.raw));
            gl.active_texture(glow::TEXTURE0);
            gl.use_program(Some(self.gather.raw));
            let place = gl.get_uniform_location(self.gather.raw, "size");
            gl.uniform_2_u32(place.as_ref(), width, height);
            gl.dispatch_compute(width.div_ceil(TILE), height.div_ceil(TILE), 1);
            gl.memory_barrier(glow::SHADER_STORAGE_BARRIER_BIT);
        }
        Ok(())
    }

    /// One step of the scan: upwards, or downwards with or without a level above.
    fn level(
        &self,
        gl: &glow::Context,
        storages: &Storages,
        (lower, count): (Storage, u32),
        upper: Storage,
        uppermost: Option<bool>,
    ) -> Result<()> {
        storages.bind(gl, bindings::LOWER_LEVEL, lower)?;
        storages.bind(gl, bindings::UPPER_LEVEL, upper)?;
        let program = if uppermost.is_some() {
            &self.spread
        } else {
            &self.reduce
        };
        // SAFETY: the program is linked; both levels have the room that `count` says.
        unsafe {
            gl.use_program(Some(program.raw));
            let place = gl.get_uniform_location(program.raw, "count");
            gl.uniform_1_u32(place.as_ref(), count);
            let place = gl.get_uniform_location(program.raw, "uppermost");
            gl.uniform_1_u32(place.as_ref(), u32::from(uppermost == Some(true)));
            gl.dispatch_compute(count.div_ceil(CHUNK).div_ceil(GROUP), 1, 1);
            gl.memory_barrier(glow::SHADER_STORAGE_BARRIER_BIT);
        }
        Ok(())
    }
}
