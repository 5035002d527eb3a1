//! The programs that listings choose from: each is linked when it is first named.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use glow::HasContext;

use super::glsl::{Declared, Files};
use super::program::{Define, ProgramKey, ProgramSet};
use crate::error::{Error, Result};
use crate::steps::Shader;

#[derive(Debug, Default)]
pub(super) struct Programs {
    pub(super) files: Files,
    /// What the shaders that were named declare.
    declared: HashMap<Shader, Declared>,
    linked: HashMap<ProgramKey, ProgramSet>,
    current: Option<ProgramKey>,
    /// What the shaders that ask for a method's defines are compiled with.
    pub(super) defines: Vec<Define>,
    /// What the programs of slices are compiled with, if any are drawn.
    pub(super) slices: Option<[Define; 2]>,
    /// Whether some surfaces are mixed.
    pub(super) mixed: bool,
    /// The near plane's distance, as the bits of a float, if depths are 1/w.
    pub(super) inverse_w: Option<u32>,
}

impl Programs {
    /// Chooses a program, with a Local Array of `size` elements if it has one. The context is current.
    pub(super) fn choose(
        &mut self,
        gl: &glow::Context,
        shader: Shader,
        size: Option<u32>,
    ) -> Result<()> {
        let size = size.map(|size| ("N", size));
        let declared = match self.declared.entry(shader) {
            Entry::Occupied(read) => read.into_mut(),
            Entry::Vacant(place) => place.insert(Declared::read(&self.files, shader)?),
        };
        let (surfaces, inverse_w) = ((self.slices, self.mixed), self.inverse_w);
        let key = ProgramKey::new(shader, declared, &self.defines, size, surfaces, inverse_w);
        if let Entry::Vacant(place) = self.linked.entry(key.clone()) {
            let linked = ProgramSet::new(gl, &self.files, declared, place.key())?;
            place.insert(linked);
        }
        if let ProgramSet::Screen(program) = &self.linked[&key] {
            // SAFETY: the program is linked.
            unsafe { gl.use_program(Some(program.raw)) };
        }
        self.current = Some(key);
        Ok(())
    }

    /// The program that was chosen.
    pub(super) fn current(&self) -> Result<&ProgramSet> {
        let linked = self.current.as_ref().and_then(|key| self.linked.get(key));
        linked.ok_or_else(|| {
            Error::out_of_order(
                "the listing draws before it chooses a program",
                "glUseProgram comes first",
            )
        })
    }

    /// The name of the program that was chosen.
    pub(super) fn current_name(&self) -> Option<&'static str> {
        self.current.as_ref().map(ProgramKey::name)
    }

    /// Has the next listing choose its program anew: OpenGL's own current program is another one now.
    pub(super) fn forget_current(&mut self) {
        self.current = None;
    }

    /// Sets a uniform of the current program. The context is current.
    pub(super) fn set_uniform(&self, gl: &glow::Context, name: &str, value: f32) {
        let current = self.current().ok();
        for program in current.into_iter().flat_map(ProgramSet::programs) {
            // SAFETY: the program is linked; GL ignores a uniform that it does not have.
            unsafe {
                gl.use_program(Some(program.raw));
                let location = gl.get_uniform_location(program.raw, name);
                gl.uniform_1_f32(location.as_ref(), value);
            }
        }
    }

    /// Lets go of every program: each is linked anew when it is named again.
    pub(super) fn delete(&mut self, gl: &glow::Context) {
        for program in self.linked.values().flat_map(ProgramSet::programs) {
            // SAFETY: the program is the machine's own, and its table is cleared below.
            unsafe { gl.delete_program(program.raw) };
        }
        self.linked.clear();
        self.declared.clear();
        self.current = None;
    }
}
