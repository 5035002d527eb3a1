//! Classic calls on a core profile. Their state is kept here, and each draw makes the uniforms and bindings of
//! `glsl/classic/` from it.

use std::collections::HashMap;

use glow::HasContext;

use super::super::bindings::{PLAIN_2D, PLAIN_RECTANGLE, SHADOW_2D, SHADOW_RECTANGLE};
use super::super::context::Context;
use super::super::geometry::Geometry;
use super::super::making::{Making, allocate, named};
use super::super::maps::Maps;
use super::super::program::ProgramSet;
use super::super::samplers::{Samplers, compare_to_reference, take_the_nearest};
use super::super::texture::{Texture, internal};
use super::state::{ClassicState, UNITS};
use crate::error::{Error, Result};
use crate::steps::{
    ClassicCall, Compare, DepthTextureMode, Format, Map, TexEnvValue, TextureTarget,
};

/// The HILO texture's unit.
const HILO: u32 = 14;

/// What a machine keeps for classic calls.
#[derive(Debug, Default)]
pub(in crate::low_level::gl) struct Classic {
    /// Nothing before the first call of a frame.
    state: Option<ClassicState>,
    /// Rectangle textures; in a table of their own, because nothing draws into them.
    rectangles: HashMap<Map, (glow::Texture, Format)>,
    /// One sampler with compare mode for each unit.
    samplers: Vec<glow::Sampler>,
    hilo: Option<Texture>,
}

/// What classic calls find in the machine around them.
#[derive(Clone, Copy)]
pub(in crate::low_level::gl) struct Around<'a, 'c> {
    pub(in crate::low_level::gl) context: &'c Context,
    pub(in crate::low_level::gl) maps: &'a Maps,
    pub(in crate::low_level::gl) samplers: &'a Samplers,
    pub(in crate::low_level::gl) geometry: Option<&'a Geometry<'c>>,
}

impl Classic {
    /// Forgets what classic calls have set.
    pub(in crate::low_level::gl) fn begin_frame(&mut self) {
        self.state = None;
    }

    /// What the classic calls have set, the camera's own matrices before the first of them.
    ///
    /// # Errors
    /// If there is no scene yet.
    fn state(&mut self, geometry: Option<&Geometry<'_>>) -> Result<&mut ClassicState> {
        let state = match self.state.take() {
            Some(state) => state,
            None => {
                let geometry = geometry.ok_or_else(|| {
                    Error::out_of_order(
                        "classic matrices are asked for before there is a camera",
                        "set_geometry first",
                    )
                })?;
                ClassicState::new(geometry.view, geometry.projection)
            }
        };
        Ok(self.state.insert(state))
    }

    pub(in crate::low_level::gl) fn perform(
        &mut self,
        call: &ClassicCall,
        around: Around<'_, '_>,
    ) -> Result<()> {
        self.state(around.geometry)?.perform(call)?;
        match *call {
            ClassicCall::CopyToRectangle { from, to } => {
                self.copy_to_rectangle(around.context, around.maps, from, to)
            }
            _ => Ok(()),
        }
    }

    pub(super) fn copy_to_rectangle(
        &mut self,
        context: &Context,
        maps: &Maps,
        from: Map,
        to: Map,
    ) -> Result<()> {
        let source = maps.get(from)?;
        let gl = context.glow();
        let [width, height] = source.size.map(|side| side as i32);
        let raw = match self.rectangles.get(&to) {
            Some(&(raw, format)) if format == source.format => raw,
            _ => {
                // SAFETY: the context is current; the texture is bound before it gets its storage.
                let raw = unsafe {
                    let mut making = Making::new(gl);
                    let raw = making.texture()?;
                    gl.active_texture(glow::TEXTURE0 + PLAIN_RECTANGLE);
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
                if let Some((old, _)) = self.rectangles.insert(to, (raw, source.format)) {
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

    /// Gives a program of the classic state what it looks at.
    pub(in crate::low_level::gl) fn prepare_draw(
        &mut self,
        linked: &ProgramSet,
        around: Around<'_, '_>,
    ) -> Result<()> {
        let gl = around.context.glow();
        self.make_samplers(gl)?;
        let hilo = self.hilo(around.context)?;
        let state = self.state(around.geometry)?.clone();
        for unit in 0..UNITS {
            self.bind_unit(unit, &state, around)?;
        }
        let formats: Vec<i32> = (0..UNITS)
            .map(|unit| self.base_format(unit, &state, around.maps))
            .collect();
        // SAFETY: the context is current, and the texture is the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + HILO);
            gl.bind_texture(glow::TEXTURE_2D, Some(hilo.raw));
            gl.active_texture(glow::TEXTURE0);
        }
        for program in linked.programs() {
            set_uniforms(gl, program.raw, &state, &formats);
        }
        Ok(())
    }

    fn bind_unit(&self, number: usize, state: &ClassicState, around: Around<'_, '_>) -> Result<()> {
        let gl = around.context.glow();
        forget_unit(gl, number);
        let Some((target, map)) = state.looked_up(number) else {
            return Ok(());
        };
        let unit = &state.units[number];
        let (first, kind, raw) = match target {
            TextureTarget::Texture2D => {
                let first = if unit.compare { SHADOW_2D } else { PLAIN_2D };
                (first, glow::TEXTURE_2D, around.maps.get(map)?.raw)
            }
            TextureTarget::Rectangle => {
                let first = if unit.compare {
                    SHADOW_RECTANGLE
                } else {
                    PLAIN_RECTANGLE
                };
                (first, glow::TEXTURE_RECTANGLE, self.rectangle(map)?)
            }
        };
        let sampler = if unit.compare {
            self.samplers[number]
        } else {
            around.samplers.plain
        };
        let at = first + number as u32;
        // SAFETY: the context is current; texture and sampler are the machine's own.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + at);
            gl.bind_texture(kind, Some(raw));
            gl.bind_sampler(at, Some(sampler));
            let func = unit.compare_func.number() as i32;
            gl.sampler_parameter_i32(self.samplers[number], glow::TEXTURE_COMPARE_FUNC, func);
        }
        Ok(())
    }

    pub(super) fn rectangle(&self, map: Map) -> Result<glow::Texture> {
        let found = self.rectangles.get(&map);
        found.map(|&(raw, _)| raw).ok_or_else(|| {
            Error::out_of_order(
                format!("there is no rectangle texture '{map}'"),
                "glCopyTexSubImage2D makes one",
            )
        })
    }

    /// What `classic/textures.glsl` calls it.
    fn base_format(&self, unit: usize, state: &ClassicState, maps: &Maps) -> i32 {
        let format = match state.looked_up(unit) {
            Some((TextureTarget::Texture2D, map)) => maps.get(map).ok().map(|t| t.format),
            Some((TextureTarget::Rectangle, map)) => {
                self.rectangles.get(&map).map(|&(_, format)| format)
            }
            None => None,
        };
        let mode = state.units[unit].depth_mode;
        match (format.is_some_and(Format::has_depth), mode) {
            (false, _) => 3,
            (true, DepthTextureMode::Luminance) => 0,
            (true, DepthTextureMode::Intensity) => 1,
            (true, DepthTextureMode::Alpha) => 2,
        }
    }

    fn make_samplers(&mut self, gl: &glow::Context) -> Result<()> {
        while self.samplers.len() < UNITS {
            // SAFETY: the context is current.
            let sampler = named("sampler", unsafe { gl.create_sampler() })?;
            take_the_nearest(gl, sampler);
            compare_to_reference(gl, sampler);
            self.samplers.push(sampler);
        }
        Ok(())
    }

    /// The 1x1 texture whose H and L are 0.
    fn hilo(&mut self, context: &Context) -> Result<Texture> {
        if let Some(texture) = self.hilo {
            return Ok(texture);
        }
        let texture = Texture::new(context.glow(), &"HILO", Format::Rg16, [1, 1])?;
        texture.clear(context);
        self.hilo = Some(texture);
        Ok(texture)
    }

    /// Lets go of what classic calls have made.
    pub(in crate::low_level::gl) fn delete(&mut self, gl: &glow::Context) {
        // SAFETY: every object is the machine's own and leaves its tables here.
        unsafe {
            for (_, (raw, _)) in self.rectangles.drain() {
                gl.delete_texture(raw);
            }
            for sampler in self.samplers.drain(..) {
                gl.delete_sampler(sampler);
            }
            if let Some(texture) = self.hilo.take() {
                gl.delete_texture(texture.raw);
            }
        }
    }
}

/// Binds nothing where a unit looks things up. What is left of an earlier draw changes no pixel, but a driver that compiles
/// programs for the textures they are used with would compile another one.
fn forget_unit(gl: &glow::Context, number: usize) {
    for (first, kind) in [
        (PLAIN_2D, glow::TEXTURE_2D),
        (SHADOW_2D, glow::TEXTURE_2D),
        (PLAIN_RECTANGLE, glow::TEXTURE_RECTANGLE),
        (SHADOW_RECTANGLE, glow::TEXTURE_RECTANGLE),
    ] {
        let at = first + number as u32;
        // SAFETY: the context is current.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + at);
            gl.bind_texture(kind, None);
            gl.bind_sampler(at, None);
        }
    }
}

fn set_uniforms(gl: &glow::Context, program: glow::Program, state: &ClassicState, formats: &[i32]) {
    let (func, reference) = state.alpha_func;
    let func = if state.alpha_test {
        func
    } else {
        Compare::Always
    };
    let targets: [i32; UNITS] = std::array::from_fn(|unit| target(state, unit));
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
            at("register_combiners").as_ref(),
            i32::from(state.register_combiners),
        );
        let combiner = state.combiner.map(|input| {
            [
                input.register as i32,
                input.mapping as i32,
                input.component as i32,
            ]
        });
        gl.uniform_3_i32_slice(at("combiner").as_ref(), combiner.as_flattened());
        gl.uniform_1_i32(
            at("alpha_func").as_ref(),
            (func.number() - glow::NEVER) as i32,
        );
        gl.uniform_1_f32(at("alpha_ref").as_ref(), reference);
        gl.uniform_1_i32(at("unsigned_hilo").as_ref(), HILO as i32);
        let replaced = state.depth_replace();
        gl.uniform_1_i32(at("replaces_depth").as_ref(), i32::from(replaced.is_some()));
        if let Some([dot_product, depth_replace]) = replaced {
            gl.uniform_1_i32(at("dot_product").as_ref(), dot_product as i32);
            let location = at("dot_product_depth_replace");
            gl.uniform_1_i32(location.as_ref(), depth_replace as i32);
        }
    }
}

fn target(state: &ClassicState, unit: usize) -> i32 {
    match (state.looked_up(unit), state.units[unit].compare) {
        (None, _) => 0,
        (Some((TextureTarget::Texture2D, _)), false) => 1,
        (Some((TextureTarget::Texture2D, _)), true) => 2,
        (Some((TextureTarget::Rectangle, _)), false) => 3,
        (Some((TextureTarget::Rectangle, _)), true) => 4,
    }
}
