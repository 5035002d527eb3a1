//! Classic calls on a core profile. Their state is kept here, and each draw makes the uniforms and bindings of
//! `glsl/classic/` from it.

use glow::HasContext;

use super::super::constants::compare;
use super::super::machine::GlMachine;
use super::super::making::{Making, allocate, named};
use super::super::program::Linked;
use super::super::texture::{Texture, internal};
use super::state::{ClassicState, TextureUnit, UNITS};
use crate::error::{Error, Result};
use crate::steps::{
    ClassicCall, Compare, DepthTextureMode, Format, Map, TexEnvValue, TextureTarget,
};

/// The texture units of the four kinds of texture in `classic/textures.glsl`, and the HILO texture's unit.
const PLAIN: u32 = 16;
const SHADOW: u32 = 20;
const RECTANGLE: u32 = 24;
const SHADOW_RECTANGLE: u32 = 28;
const HILO: u32 = 14;

impl GlMachine<'_> {
    /// The state that the classic calls have set. Before the first call it has the camera's matrices.
    ///
    /// # Errors
    /// If there is no scene yet.
    pub fn classic_state(&mut self) -> Result<&mut ClassicState> {
        if self.classic.state.is_none() {
            let geometry = self.geometry.as_ref().ok_or_else(|| {
                Error::usage(
                    "classic matrices are asked for before there is a camera",
                    "set_geometry first",
                )
            })?;
            self.classic.state = Some(ClassicState::new(geometry.view, geometry.projection));
        }
        Ok(self.classic.state.as_mut().expect("it has just been made"))
    }

    pub(in crate::gl) fn classic_call(&mut self, call: &ClassicCall) -> Result<()> {
        self.classic_state()?.perform(call)?;
        match *call {
            ClassicCall::CopyToRectangle { from, to } => self.copy_to_rectangle(from, to),
            _ => Ok(()),
        }
    }

    pub(super) fn copy_to_rectangle(&mut self, from: Map, to: Map) -> Result<()> {
        let source = self.texture(from)?;
        let gl = self.context.glow();
        let [width, height] = source.size.map(|side| side as i32);
        let raw = match self.classic.rectangles.get(&to) {
            Some(&(raw, format)) if format == source.format => raw,
            _ => {
                // SAFETY: the context is current; the texture is bound before it gets its storage.
                let raw = unsafe {
                    let mut making = Making::new(gl);
                    let raw = making.texture()?;
                    gl.active_texture(glow::TEXTURE0 + RECTANGLE);
                    gl.bind_texture(glow::TEXTURE_RECTANGLE, Some(raw));
                    let what = format!("the rectangle texture '{to}'");
                    let room = allocate(gl, &what, source.bytes(), || {
                        let format = internal(source.format);
                        gl.tex_storage_2d(glow::TEXTURE_RECTANGLE, 1, format, width, height);
                    });
                    gl.bind_texture(glow::TEXTURE_RECTANGLE, None);
                    gl.active_texture(glow::TEXTURE0);
                    room?;
                    making.finish();
                    raw
                };
                if let Some((old, _)) = self.classic.rectangles.insert(to, (raw, source.format)) {
                    // SAFETY: the texture was the machine's own and has left its table.
                    unsafe { gl.delete_texture(old) };
                }
                raw
            }
        };
        let (two_d, rectangle) = (glow::TEXTURE_2D, glow::TEXTURE_RECTANGLE);
        // SAFETY: both textures are the machine's, of one size and one format.
        unsafe {
            gl.copy_image_sub_data(
                source.raw, two_d, 0, 0, 0, 0, raw, rectangle, 0, 0, 0, 0, width, height, 1,
            );
        }
        Ok(())
    }

    /// Sets the uniforms and bindings of the current program, which is one of `glsl/classic/`.
    pub(in crate::gl) fn set_classic_uniforms(&mut self) -> Result<()> {
        self.make_samplers()?;
        let hilo = self.hilo()?;
        let state = self.classic_state()?.clone();
        for unit in 0..UNITS {
            self.bind_unit(unit, &state.units[unit])?;
        }
        let gl = self.context.glow();
        let formats: Vec<i32> = state
            .units
            .iter()
            .map(|unit| self.base_format(unit))
            .collect();
        // SAFETY: the context is current; each location is the program's own or none, which GL ignores.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + HILO);
            gl.bind_texture(glow::TEXTURE_2D, Some(hilo.raw));
            gl.active_texture(glow::TEXTURE0);
        }
        let linked = self.current.as_ref().and_then(|key| self.programs.get(key));
        for program in linked.into_iter().flat_map(Linked::programs) {
            self.set_uniforms(program.raw, &state, &formats);
        }
        Ok(())
    }

    fn set_uniforms(&self, program: glow::Program, state: &ClassicState, formats: &[i32]) {
        let gl = self.context.glow();
        let (func, reference) = state.alpha_func;
        let func = if state.alpha_test {
            func
        } else {
            Compare::Always
        };
        let targets = state.units.each_ref().map(target);
        let modes = state.units.each_ref().map(|unit| match unit.environment {
            TexEnvValue::Replace => 1,
            TexEnvValue::Modulate => 2,
            _ => 0,
        });
        let texgen = state.units.each_ref().map(|unit| i32::from(unit.texgen));
        let planes: Vec<f32> = state
            .units
            .iter()
            .flat_map(|unit| unit.eye_planes)
            .flat_map(|plane| plane.as_vec4().to_array())
            .collect();
        let matrices: Vec<f32> = (0..UNITS)
            .flat_map(|unit| state.texture_matrix(unit).as_mat4().to_cols_array())
            .collect();
        let modelview = state.modelview().as_mat4().to_cols_array();
        // SAFETY: the context is current and the program linked; each location is its own or none, which GL ignores,
        // and each array has as many elements as the shaders declare.
        unsafe {
            gl.use_program(Some(program));
            let at = |name: &str| gl.get_uniform_location(program, name);
            gl.uniform_matrix_4_f32_slice(at("modelview").as_ref(), false, &modelview);
            gl.uniform_1_i32_slice(at("texgen").as_ref(), &texgen);
            gl.uniform_4_f32_slice(at("eye_planes").as_ref(), &planes);
            gl.uniform_matrix_4_f32_slice(at("texture_matrix").as_ref(), false, &matrices);
            gl.uniform_1_i32_slice(at("target").as_ref(), &targets);
            gl.uniform_1_i32_slice(at("base_format").as_ref(), formats);
            gl.uniform_1_i32_slice(at("env_mode").as_ref(), &modes);
            gl.uniform_1_i32(
                at("alpha_func").as_ref(),
                (compare(func) - glow::NEVER) as i32,
            );
            gl.uniform_1_f32(at("alpha_ref").as_ref(), reference);
            gl.uniform_1_i32(at("unsigned_hilo").as_ref(), HILO as i32);
            if let Some([dot_product, depth_replace]) = state.depth_replace() {
                gl.uniform_1_i32(at("dot_product").as_ref(), dot_product as i32);
                let location = at("dot_product_depth_replace");
                gl.uniform_1_i32(location.as_ref(), depth_replace as i32);
            }
        }
    }

    fn bind_unit(&self, number: usize, unit: &TextureUnit) -> Result<()> {
        let gl = self.context.glow();
        let Some((target, map)) = unit.enabled() else {
            return Ok(());
        };
        let (first, kind, raw) = match target {
            TextureTarget::Texture2D => {
                let first = if unit.compare { SHADOW } else { PLAIN };
                (first, glow::TEXTURE_2D, self.texture(map)?.raw)
            }
            TextureTarget::Rectangle => {
                let first = if unit.compare {
                    SHADOW_RECTANGLE
                } else {
                    RECTANGLE
                };
                (first, glow::TEXTURE_RECTANGLE, self.rectangle(map)?)
            }
        };
        let sampler = if unit.compare {
            self.classic.samplers[number]
        } else {
            self.plain_sampler
        };
        let at = first + number as u32;
        // SAFETY: the context is current; texture and sampler are the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + at);
            gl.bind_texture(kind, Some(raw));
            gl.bind_sampler(at, Some(sampler));
            let func = compare(unit.compare_func) as i32;
            gl.sampler_parameter_i32(
                self.classic.samplers[number],
                glow::TEXTURE_COMPARE_FUNC,
                func,
            );
        }
        Ok(())
    }

    pub(super) fn rectangle(&self, map: Map) -> Result<glow::Texture> {
        let found = self.classic.rectangles.get(&map);
        found.map(|&(raw, _)| raw).ok_or_else(|| {
            Error::usage(
                format!("there is no rectangle texture '{map}'"),
                "glCopyTexSubImage2D makes one",
            )
        })
    }

    /// Its number in `classic/textures.glsl`.
    fn base_format(&self, unit: &TextureUnit) -> i32 {
        let format = match unit.enabled() {
            Some((TextureTarget::Texture2D, map)) => self.texture(map).ok().map(|t| t.format),
            Some((TextureTarget::Rectangle, map)) => {
                self.classic.rectangles.get(&map).map(|&(_, format)| format)
            }
            None => None,
        };
        match (format.is_some_and(Format::has_depth), unit.depth_mode) {
            (false, _) => 3,
            (true, DepthTextureMode::Luminance) => 0,
            (true, DepthTextureMode::Intensity) => 1,
            (true, DepthTextureMode::Alpha) => 2,
        }
    }

    fn make_samplers(&mut self) -> Result<()> {
        let gl = self.context.glow();
        while self.classic.samplers.len() < UNITS {
            // SAFETY: the context is current, and the sampler is set up before it is used.
            let sampler = unsafe {
                let sampler = named("sampler", gl.create_sampler())?;
                for (name, value) in [
                    (glow::TEXTURE_MIN_FILTER, glow::NEAREST),
                    (glow::TEXTURE_MAG_FILTER, glow::NEAREST),
                    (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                    (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                    (glow::TEXTURE_COMPARE_MODE, glow::COMPARE_REF_TO_TEXTURE),
                ] {
                    gl.sampler_parameter_i32(sampler, name, value as i32);
                }
                sampler
            };
            self.classic.samplers.push(sampler);
        }
        Ok(())
    }

    /// The 1x1 texture whose H and L are 0.
    fn hilo(&mut self) -> Result<Texture> {
        if let Some(texture) = self.classic.hilo {
            return Ok(texture);
        }
        let texture = Texture::new(self.context.glow(), &"HILO", Format::Rg16, [1, 1])?;
        texture.clear(self.context);
        self.classic.hilo = Some(texture);
        Ok(texture)
    }

    /// Deletes the objects that classic calls have made.
    pub(in crate::gl) fn free_classic(&mut self) {
        let gl = self.context.glow();
        // SAFETY: every object is the machine's own and leaves its tables here.
        unsafe {
            for (_, (raw, _)) in self.classic.rectangles.drain() {
                gl.delete_texture(raw);
            }
            for sampler in self.classic.samplers.drain(..) {
                gl.delete_sampler(sampler);
            }
            if let Some(texture) = self.classic.hilo.take() {
                gl.delete_texture(texture.raw);
            }
        }
    }
}

fn target(unit: &TextureUnit) -> i32 {
    match (unit.enabled(), unit.compare) {
        (None, _) => 0,
        (Some((TextureTarget::Texture2D, _)), false) => 1,
        (Some((TextureTarget::Texture2D, _)), true) => 2,
        (Some((TextureTarget::Rectangle, _)), false) => 3,
        (Some((TextureTarget::Rectangle, _)), true) => 4,
    }
}
