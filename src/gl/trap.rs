//! Testing for known errors of drivers.

use glow::HasContext;

use super::bindings::COUNTER;
use super::driver::{LOST_ATOMICS, Trap};
use super::machine::GlMachine;
use super::making::{Making, allocate};
use crate::error::Result;
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
        let context = self.context;
        let _visit = context.visit()?;
        let counted = self.count_invocations(DRAWS)?;
        Ok(if counted == DRAWS * width * height {
            vec![]
        } else {
            vec![LOST_ATOMICS]
        })
    }

    /// The count of a shader that runs over the whole screen several times, unblended, in a framebuffer without depth,
    /// which are the conditions of [`LOST_ATOMICS`].
    fn count_invocations(&mut self, draws: u32) -> Result<u32> {
        self.begin_frame();
        self.allocate(COLOR, Format::Rgba8)?;
        self.framebuffer(TARGET, Some(COLOR), None)?;
        let gl = self.context().glow();
        // It is deleted at the end, and whenever a step fails.
        let mut making = Making::new(gl);
        let counter = making.buffer()?;
        // SAFETY: the context is current, and the buffer has its storage before the shader adds to it.
        unsafe {
            gl.bind_buffer_base(glow::SHADER_STORAGE_BUFFER, COUNTER, Some(counter));
            allocate(gl, "the counter of invocations", 4, || {
                gl.buffer_data_u8_slice(glow::SHADER_STORAGE_BUFFER, &[0; 4], glow::DYNAMIC_READ);
            })?;
        }
        self.perform(&Call::UseProgram {
            program: Shader("trap"),
        })?;
        for _ in 0..draws {
            self.perform(&Call::Draw {
                objects: Objects::Screen,
            })?;
        }
        let mut counted = 0_u32;
        // SAFETY: the shader's writes are waited for.
        unsafe {
            gl.memory_barrier(glow::BUFFER_UPDATE_BARRIER_BIT);
            gl.get_buffer_sub_data(
                glow::SHADER_STORAGE_BUFFER,
                0,
                bytemuck::bytes_of_mut(&mut counted),
            );
        }
        Ok(counted)
    }
}
