//! Looking for the ways in which drivers are known to go wrong.

use glow::HasContext;

use super::driver::{LOST_ATOMICS, Trap};
use super::machine::GlMachine;
use crate::error::{Error, Result};
use crate::steps::{Call, Format, Machine, Map, Objects, Shader, Target};

const COLOR: Map = Map::named("trap color");
const TARGET: Target = Target("trap");

impl GlMachine<'_> {
    /// The known traps that this driver has.
    ///
    /// # Errors
    /// If a trap cannot be tried.
    pub fn traps(&mut self) -> Result<Vec<Trap>> {
        // Enough full-screen triangles for the driver to bin several of them for each of its tiles.
        const DRAWS: u32 = 16;
        let [width, height] = self.size();
        let counted = self.count_invocations(DRAWS)?;
        Ok(if counted == DRAWS * width * height {
            vec![]
        } else {
            vec![LOST_ATOMICS]
        })
    }

    /// How often a counting shader runs over the whole screen, in a framebuffer without depth, unblended: the conditions
    /// of [`LOST_ATOMICS`].
    fn count_invocations(&mut self, draws: u32) -> Result<u32> {
        self.begin_frame();
        self.allocate(COLOR, Format::Rgba8)?;
        self.target(TARGET, Some(COLOR), None)?;
        let out = |what: String| Error::Driver {
            what,
            remedy: "the driver is out of memory or lost".into(),
        };
        let gl = self.context().glow();
        // SAFETY: the context is current, and the buffer has its storage before the shader adds to it.
        let counter = unsafe {
            let counter = gl.create_buffer().map_err(out)?;
            gl.bind_buffer_base(glow::SHADER_STORAGE_BUFFER, 0, Some(counter));
            gl.buffer_data_u8_slice(glow::SHADER_STORAGE_BUFFER, &[0; 4], glow::DYNAMIC_READ);
            counter
        };
        self.perform(&Call::UseProgram {
            program: Shader("trap"),
        })?;
        for _ in 0..draws {
            self.perform(&Call::Draw {
                objects: Objects::Screen,
            })?;
        }
        let mut counted = 0_u32;
        // SAFETY: the shader's writes are waited for; the buffer is deleted once it has been read.
        unsafe {
            gl.memory_barrier(glow::BUFFER_UPDATE_BARRIER_BIT);
            gl.get_buffer_sub_data(
                glow::SHADER_STORAGE_BUFFER,
                0,
                bytemuck::bytes_of_mut(&mut counted),
            );
            gl.delete_buffer(counter);
        }
        Ok(counted)
    }
}
