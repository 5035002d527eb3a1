//! The prefix scan that gives each pixel of a DFB its base offset (Maule et al. 2012; Lindholm et al. 2015, section 4),
//! in compute shaders, over any number of pixels.
//!
//! Level 0 holds the pixels' counts. Each number of a higher level is the sum of 64 numbers of the level below. Then,
//! from the top down, each number becomes the sum of those before it.

use glow::HasContext;

use super::machine::GlMachine;
use super::making::Making;
use super::program::Program;
use crate::error::Result;
use crate::steps::{Call, Machine, Map, Storage};

/// The count of numbers of a level whose sum is a number of the next level.
const CHUNK: u32 = 64;
/// Invocations in a work group of `scan_reduce.comp` and `scan_spread.comp`.
const GROUP: u32 = 256;
/// Work group sides of `scan_gather.comp`.
const TILE: u32 = 16;

/// Levels above the first: 64^6 is more than any image has pixels.
const LEVELS: [Storage; 6] = [
    Storage("scan level 1"),
    Storage("scan level 2"),
    Storage("scan level 3"),
    Storage("scan level 4"),
    Storage("scan level 5"),
    Storage("scan level 6"),
];

/// The three programs.
#[derive(Debug)]
pub(super) struct ScanPrograms {
    gather: Program,
    reduce: Program,
    spread: Program,
}

impl ScanPrograms {
    fn new(gl: &glow::Context) -> Result<Self> {
        let mut making = Making::new(gl);
        let mut link = |file| Program::link(&mut making, &[file], &[]);
        let programs = Self {
            gather: link("a_buffer/scan_gather.comp")?,
            reduce: link("a_buffer/scan_reduce.comp")?,
            spread: link("a_buffer/scan_spread.comp")?,
        };
        making.finish();
        Ok(programs)
    }

    pub(super) fn delete(&self, gl: &glow::Context) {
        for program in [&self.gather, &self.reduce, &self.spread] {
            // SAFETY: the programs are its own, and its owner lets go of it.
            unsafe { gl.delete_program(program.raw) };
        }
    }
}

impl GlMachine<'_> {
    /// Bytes of the buffers that [`prefix_scan`](Self::prefix_scan) needs for so many numbers, the result included.
    pub fn scan_bytes(numbers: u64) -> u64 {
        let levels = std::iter::successors(Some(numbers), |&n| {
            (n > 1).then(|| n.div_ceil(u64::from(CHUNK)))
        });
        // A level cannot be smaller than the smallest buffer.
        levels.map(|n| (n * 4).max(16)).sum()
    }

    /// Makes `offsets` hold, for each pixel of the image, the sum of the counts of the pixels before it, row by row from the
    /// bottom, modulo 2^32. `counts` is a map of whole numbers in float texels.
    ///
    /// # Errors
    /// If the driver has no room.
    pub fn prefix_scan(&mut self, counts: Map, offsets: Storage) -> Result<()> {
        let [width, height] = self.size;
        let numbers = width * height;
        if self.scan.is_none() {
            self.scan = Some(ScanPrograms::new(self.context.glow())?);
        }
        self.allocate_storage(offsets, u64::from(numbers) * 4, None)?;
        // (buffer, how many numbers), from the pixels up to a single number.
        let mut levels = vec![(offsets, numbers)];
        for level in LEVELS {
            let (_, below) = levels[levels.len() - 1];
            if below <= 1 {
                break;
            }
            let here = below.div_ceil(CHUNK);
            self.allocate_storage(level, u64::from(here) * 4, None)?;
            levels.push((level, here));
        }
        self.perform(&Call::ActiveTexture { unit: 1 })?;
        self.perform(&Call::BindTexture { texture: counts })?;
        self.perform(&Call::ActiveTexture { unit: 0 })?;
        self.gather(offsets)?;
        for pair in levels.windows(2) {
            self.level(pair[0], pair[1].0, None)?;
        }
        let (top, numbers) = levels[levels.len() - 1];
        self.level((top, numbers), top, Some(true))?;
        for pair in levels.windows(2).rev() {
            self.level(pair[0], pair[1].0, Some(false))?;
        }
        // A listing chooses its program anew.
        self.current = None;
        Ok(())
    }

    fn gather(&mut self, counts: Storage) -> Result<()> {
        let [width, height] = self.size;
        self.perform(&Call::BindStorage {
            index: 0,
            buffer: counts,
        })?;
        let gl = self.context.glow();
        if let Some(scan) = &self.scan {
            // SAFETY: the program is linked; the shader writes only the numbers that the buffer has room for.
            unsafe {
                gl.use_program(Some(scan.gather.raw));
                let place = gl.get_uniform_location(scan.gather.raw, "size");
                gl.uniform_2_u32(place.as_ref(), width, height);
                gl.dispatch_compute(width.div_ceil(TILE), height.div_ceil(TILE), 1);
                gl.memory_barrier(glow::SHADER_STORAGE_BARRIER_BIT);
            }
        }
        Ok(())
    }

    /// One step of the scan: upwards, or downwards with or without a level above.
    fn level(
        &mut self,
        (lower, count): (Storage, u32),
        upper: Storage,
        uppermost: Option<bool>,
    ) -> Result<()> {
        for (index, buffer) in [(0, lower), (1, upper)] {
            self.perform(&Call::BindStorage { index, buffer })?;
        }
        let gl = self.context.glow();
        if let Some(scan) = &self.scan {
            let program = if uppermost.is_some() {
                &scan.spread
            } else {
                &scan.reduce
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
        }
        Ok(())
    }
}
