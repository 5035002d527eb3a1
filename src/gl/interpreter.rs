//! The interpreter: every call of a listing becomes a call of GL. This happens nowhere else.

use std::collections::hash_map::Entry;

use glow::HasContext;

use super::constants::{
    blend_equation, blend_factor, capability, clear_bits, compare, error_name, stencil_op,
};
use super::framebuffers::depth_attachment;
use super::geometry::Geometry;
use super::machine::GlMachine;
use super::making::named;
use super::program::{Linked, ProgramKey};
use super::texture::internal;
use crate::error::{Error, Result};
use crate::steps::{Call, Machine, Map, Objects, Query, Shader};

impl Machine for GlMachine<'_> {
    /// In debug builds the step's text names a debug group around it, and OpenGL's errors are asked for after it.
    fn perform(&mut self, call: &Call) -> Result<()> {
        self.context.expect_current()?;
        if !cfg!(debug_assertions) {
            return self.execute(call);
        }
        let gl = self.context.glow();
        self.context.note_errors_outside_of_visits();
        let step = call.to_string();
        // SAFETY: the context is current; the group that is pushed is popped.
        unsafe { gl.push_debug_group(glow::DEBUG_SOURCE_APPLICATION, 0, &step) };
        let done = self.execute(call);
        // SAFETY: as above.
        let error = unsafe {
            gl.pop_debug_group();
            gl.get_error()
        };
        done?;
        match error {
            glow::NO_ERROR => Ok(()),
            error => Err(Error::Step {
                step,
                error: error_name(error).into(),
            }),
        }
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        let raw = self.queries.get(&query).copied().ok_or_else(|| {
            let what = format!("the listing asks the query '{}' before it is made", query.0);
            Error::usage(what, "glBeginQuery and glEndQuery come first")
        })?;
        // SAFETY: the query has begun and ended.
        Ok(unsafe {
            self.context
                .glow()
                .get_query_parameter_u64(raw, glow::QUERY_RESULT)
        })
    }
}

impl GlMachine<'_> {
    fn use_program(&mut self, shader: Shader, size: Option<(&'static str, u32)>) -> Result<()> {
        let gl = self.context.glow();
        let key = ProgramKey::new(shader, &self.constants, size, self.slices, self.inverse_w);
        if let Entry::Vacant(place) = self.programs.entry(key.clone()) {
            let linked = Linked::new(gl, place.key())?;
            place.insert(linked);
        }
        if let Linked::Screen(program) = &self.programs[&key] {
            // SAFETY: the program is linked.
            unsafe { gl.use_program(Some(program.raw)) };
        }
        self.current = Some(key);
        Ok(())
    }

    fn query(&mut self, query: Query) -> Result<glow::Query> {
        if let Some(query) = self.queries.get(&query) {
            return Ok(*query);
        }
        // SAFETY: the context is current.
        let made = named("query", unsafe { self.context.glow().create_query() })?;
        self.queries.insert(query, made);
        Ok(made)
    }

    fn copy(&mut self, from: Map, to: Map) -> Result<()> {
        let source = self.texture(from)?;
        self.allocate(to, source.format)?;
        let destination = self.texture(to)?;
        let [width, height] = self.size.map(|side| side as i32);
        // SAFETY: both textures are the machine's, of one size and one format.
        unsafe {
            self.context.glow().copy_image_sub_data(
                source.raw,
                glow::TEXTURE_2D,
                0,
                0,
                0,
                0,
                destination.raw,
                glow::TEXTURE_2D,
                0,
                0,
                0,
                0,
                width,
                height,
                1,
            );
        }
        Ok(())
    }

    fn swap(&mut self, a: Map, b: Map) -> Result<()> {
        let (of_a, of_b) = (self.texture(a)?, self.texture(b)?);
        self.textures.insert(a, of_b);
        self.textures.insert(b, of_a);
        Ok(())
    }

    fn set_uniform(&self, name: &str, value: f32) {
        let gl = self.context.glow();
        let linked = self.current.as_ref().and_then(|key| self.programs.get(key));
        for program in linked.into_iter().flat_map(Linked::programs) {
            // SAFETY: the program is linked; GL ignores a uniform that it does not have.
            unsafe {
                gl.use_program(Some(program.raw));
                let location = gl.get_uniform_location(program.raw, name);
                gl.uniform_1_f32(location.as_ref(), value);
            }
        }
    }

    fn whole(&self) -> [i32; 4] {
        [0, 0, self.size[0] as i32, self.size[1] as i32]
    }

    fn draw(&mut self, objects: Objects) -> Result<()> {
        if self
            .current
            .as_ref()
            .is_some_and(|key| key.shader.0.starts_with("classic/"))
        {
            self.set_classic_uniforms()?;
        }
        let no_program = || {
            Error::usage(
                "the listing draws before it chooses a program",
                "glUseProgram comes first",
            )
        };
        let program = self
            .current
            .as_ref()
            .and_then(|key| self.programs.get(key))
            .ok_or_else(no_program)?;
        match (program, objects) {
            (Linked::Screen(_), Objects::Screen) => {
                let gl = self.context.glow();
                // A draw over the screen works on layers of transparent surfaces, so it need not reach further than
                // they do.
                let [x, mut y, width, mut height] = self
                    .geometry
                    .as_ref()
                    .map_or(self.whole(), Geometry::window);
                if let Some([first, rows]) = self.band {
                    let (low, high) = (first as i32, (first + rows) as i32);
                    let top = (y + height).clamp(low, high);
                    y = y.clamp(low, high);
                    height = top - y;
                }
                // SAFETY: the program is current and reads no attributes, and the array has none.
                unsafe {
                    gl.enable_draw_buffer(glow::SCISSOR_TEST, 0);
                    gl.scissor_slice(0, 1, &[[x, y, width, height]]);
                    gl.bind_vertex_array(Some(self.no_attributes));
                    gl.draw_arrays(glow::TRIANGLES, 0, 3);
                }
                self.scissor_to_band();
            }
            (
                Linked::Surface(surfaces),
                Objects::Scene
                | Objects::Opaque
                | Objects::Transparent
                | Objects::Sorted
                | Objects::Unsorted
                | Objects::Proxies,
            ) => {
                let no_scene = || {
                    Error::usage(
                        "the listing draws a scene before there is one",
                        "set_geometry first",
                    )
                };
                let geometry = self.geometry.as_ref().ok_or_else(no_scene)?;
                geometry.expect_context(self.context)?;
                let drawn = geometry.draw(surfaces, objects);
                if drawn && !matches!(objects, Objects::Opaque | Objects::Proxies) {
                    self.counts.geometry_passes += 1;
                }
            }
            _ => {
                return Err(Error::usage(
                    format!("the current program does not draw {objects:?}"),
                    "choose one for the screen or one for surfaces with glUseProgram",
                ));
            }
        }
        Ok(())
    }

    fn execute(&mut self, call: &Call) -> Result<()> {
        let gl = self.context.glow();
        // SAFETY: the context is current. Every constant comes from an enum of OpenGL's own, every object from this
        // machine's tables.
        unsafe {
            match *call {
                Call::ClearColor {
                    red,
                    green,
                    blue,
                    alpha,
                } => gl.clear_color(red, green, blue, alpha),
                Call::ClearDepth { depth } => gl.clear_depth_f64(depth),
                Call::ClearStencil { s } => gl.clear_stencil(s),
                Call::Clear { mask } => gl.clear(clear_bits(mask)),
                Call::Enable { cap } => gl.enable(capability(cap)),
                Call::Disable { cap } => gl.disable(capability(cap)),
                Call::DepthFunc { func } => gl.depth_func(compare(func)),
                Call::DepthMask { flag } => gl.depth_mask(flag),
                Call::ColorMask {
                    red,
                    green,
                    blue,
                    alpha,
                } => gl.color_mask(red, green, blue, alpha),
                Call::ColorMaski {
                    buf,
                    red,
                    green,
                    blue,
                    alpha,
                } => gl.color_mask_draw_buffer(buf, red, green, blue, alpha),
                Call::StencilMask { mask } => gl.stencil_mask(mask),
                Call::StencilFunc {
                    func,
                    reference,
                    mask,
                } => gl.stencil_func(compare(func), reference, mask),
                Call::StencilOp {
                    sfail,
                    dpfail,
                    dppass,
                } => {
                    gl.stencil_op(stencil_op(sfail), stencil_op(dpfail), stencil_op(dppass));
                }
                Call::BlendFunc { sfactor, dfactor } => {
                    gl.blend_func(blend_factor(sfactor), blend_factor(dfactor))
                }
                Call::BlendFuncSeparate {
                    src_rgb,
                    dst_rgb,
                    src_alpha,
                    dst_alpha,
                } => {
                    gl.blend_func_separate(
                        blend_factor(src_rgb),
                        blend_factor(dst_rgb),
                        blend_factor(src_alpha),
                        blend_factor(dst_alpha),
                    );
                }
                Call::ActiveDepthUnit { .. } | Call::BindDepthBuffer { .. } => {
                    return Err(Error::usage(
                        format!("OpenGL has no depth units, so {call} cannot be performed"),
                        "run the listing through steps::DepthUnits",
                    ));
                }
                Call::ActiveTexture { unit } => gl.active_texture(glow::TEXTURE0 + unit),
                Call::BindTexture { texture } => {
                    let texture = self.texture(texture)?;
                    gl.bind_texture(glow::TEXTURE_2D, Some(texture.raw));
                }
                Call::SamplerCompareFunc { func } => {
                    let func = compare(func) as i32;
                    gl.sampler_parameter_i32(self.shadow_sampler, glow::TEXTURE_COMPARE_FUNC, func);
                }
                Call::UseProgram { program } => self.use_program(program, None)?,
                Call::UseProgramOfSize { program, size } => {
                    self.use_program(program, Some(("N", size.known()?)))?;
                }
                Call::StencilReference {
                    func,
                    reference,
                    mask,
                } => {
                    gl.stencil_func(compare(func), reference.known()?, mask);
                }
                Call::BlendEquationi { buf, mode } => {
                    gl.blend_equation_draw_buffer(buf, blend_equation(mode));
                }
                Call::BlendFunci { buf, src, dst } => {
                    gl.blend_func_draw_buffer(buf, blend_factor(src), blend_factor(dst));
                }
                Call::ClearFloats { drawbuffer, value } => {
                    gl.clear_buffer_f32_slice(glow::COLOR, drawbuffer, &value);
                }
                Call::ClearIntegers { drawbuffer } => {
                    gl.clear_buffer_u32_slice(glow::COLOR, drawbuffer, &[0; 4]);
                }
                Call::BindImage { unit, texture } => {
                    let texture = self.texture(texture)?;
                    let format = internal(texture.format);
                    gl.bind_image_texture(
                        unit,
                        Some(texture.raw),
                        0,
                        false,
                        0,
                        glow::READ_WRITE,
                        format,
                    );
                }
                Call::BindStorage { index, buffer } => {
                    let raw = Some(self.storage(buffer)?.raw);
                    gl.bind_buffer_base(glow::SHADER_STORAGE_BUFFER, index, raw);
                }
                Call::MemoryBarrier => gl.memory_barrier(glow::ALL_BARRIER_BITS),
                Call::BindFramebuffer { framebuffer } => self.bind_framebuffer(framebuffer)?,
                Call::AttachColor { texture } => {
                    let raw = Some(self.texture(texture)?.raw);
                    gl.framebuffer_texture_2d(
                        glow::FRAMEBUFFER,
                        glow::COLOR_ATTACHMENT0,
                        glow::TEXTURE_2D,
                        raw,
                        0,
                    );
                }
                Call::AttachDepth { texture } => {
                    let texture = self.texture(texture)?;
                    gl.framebuffer_texture_2d(
                        glow::FRAMEBUFFER,
                        depth_attachment(Some(texture)),
                        glow::TEXTURE_2D,
                        Some(texture.raw),
                        0,
                    );
                }
                Call::BeginQuery { query } => {
                    let query = self.query(query)?;
                    gl.begin_query(glow::SAMPLES_PASSED, query);
                    self.counting = true;
                }
                Call::EndQuery { .. } => {
                    gl.end_query(glow::SAMPLES_PASSED);
                    self.counting = false;
                }
                Call::CopyImage { from, to } => self.copy(from, to)?,
                Call::Swap { a, b } => self.swap(a, b)?,
                Call::Draw { objects } => self.draw(objects)?,
                Call::Uniform { name, value } => self.set_uniform(name, value.known()?),
                Call::Classic(ref call) => self.classic_call(call)?,
            }
        }
        Ok(())
    }
}
