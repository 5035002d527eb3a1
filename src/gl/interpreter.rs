//! The interpreter: every call of a listing becomes a call of GL. This happens nowhere else.

use glow::HasContext;

use super::classic::Around;
use super::constants::error_name;
use super::framebuffers::depth_attachment;
use super::geometry::Geometry;
use super::machine::GlMachine;
use super::program::ProgramSet;
use super::texture::internal;
use crate::error::{Error, Result};
use crate::steps::{Call, CallLine, Machine, Objects, Query};

impl Machine for GlMachine<'_> {
    /// In debug builds the step's text names a debug group around it, and OpenGL's errors are asked for after it.
    fn perform(&mut self, call: &Call) -> Result<()> {
        self.context.expect_current()?;
        if !cfg!(debug_assertions) {
            self.execute(call)?;
            return self.show(call);
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
            glow::NO_ERROR => self.show(call),
            error => Err(Error::Step {
                step,
                error: error_name(error).into(),
            }),
        }
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.queries.samples(self.context.glow(), query)
    }

    fn follow(&mut self, line: &CallLine) {
        self.watch.follow(line);
    }
}

impl GlMachine<'_> {
    fn whole(&self) -> [i32; 4] {
        [0, 0, self.size()[0] as i32, self.size()[1] as i32]
    }

    fn draw(&mut self, objects: Objects) -> Result<()> {
        let program = self.programs.current()?;
        if program.is_classic() {
            let around = Around {
                context: self.context,
                maps: &self.maps,
                samplers: &self.samplers,
                geometry: self.geometry.as_ref(),
            };
            self.classic.prepare_draw(program, around)?;
        }
        match (program, objects) {
            (ProgramSet::Screen(_), Objects::Screen) => {
                let gl = self.context.glow();
                // A draw over the screen works on layers of transparent surfaces, so it need not reach further than
                // they do.
                let window = || {
                    self.geometry
                        .as_ref()
                        .map_or(self.whole(), Geometry::window)
                };
                let screen = self.screen.map(|screen| screen.map(|side| side as i32));
                let [x, mut y, width, mut height] = screen.unwrap_or_else(window);
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
                ProgramSet::Surface(surfaces),
                Objects::Scene
                | Objects::Opaque
                | Objects::Transparent
                | Objects::Sorted
                | Objects::Unsorted
                | Objects::Proxies,
            ) => {
                let no_scene = || {
                    Error::out_of_order(
                        "the listing draws a scene before there is one",
                        "set_geometry first",
                    )
                };
                let geometry = self.geometry.as_ref().ok_or_else(no_scene)?;
                geometry.expect_context(self.context)?;
                let drawn = geometry.draw(surfaces, objects);
                if let (Some(triangles), false) =
                    (drawn, matches!(objects, Objects::Opaque | Objects::Proxies))
                {
                    self.geometry_passes += 1;
                    self.triangles += triangles;
                }
            }
            _ => {
                return Err(Error::out_of_order(
                    format!("the current program does not draw {objects:?}"),
                    "choose one for the screen or one for surfaces with glUseProgram",
                ));
            }
        }
        Ok(())
    }

    /// Executes a call, and times it if steps are timed.
    fn execute(&mut self, call: &Call) -> Result<()> {
        if !self.step_times.are_timed() || !does_work(call) {
            return self.carry_out(call);
        }
        let program = match call {
            Call::Draw { .. } => self.programs.current_name(),
            _ => None,
        };
        let step = match program {
            Some(program) => format!("{program}: {call}"),
            None => call.to_string(),
        };
        let gl = self.context.glow();
        let begun = self.step_times.begin_step(gl)?;
        let done = self.carry_out(call);
        self.step_times.end_step(gl, begun, step);
        done
    }

    fn carry_out(&mut self, call: &Call) -> Result<()> {
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
                Call::Clear { mask } => gl.clear(mask.number()),
                Call::Enable { cap } => gl.enable(cap.number()),
                Call::Disable { cap } => gl.disable(cap.number()),
                Call::DepthFunc { func } => gl.depth_func(func.number()),
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
                } => gl.stencil_func(func.number(), reference, mask),
                Call::StencilOp {
                    sfail,
                    dpfail,
                    dppass,
                } => {
                    gl.stencil_op(sfail.number(), dpfail.number(), dppass.number());
                }
                Call::BlendFunc { sfactor, dfactor } => {
                    gl.blend_func(sfactor.number(), dfactor.number())
                }
                Call::BlendFuncSeparate {
                    src_rgb,
                    dst_rgb,
                    src_alpha,
                    dst_alpha,
                } => {
                    gl.blend_func_separate(
                        src_rgb.number(),
                        dst_rgb.number(),
                        src_alpha.number(),
                        dst_alpha.number(),
                    );
                }
                Call::ActiveDepthUnit { .. } | Call::BindDepthBuffer { .. } => {
                    return Err(Error::CannotPerform {
                        machine: "OpenGL",
                        call: call.to_string(),
                        why: "it has no depth units",
                        remedy: "run the listing through steps::DepthUnits",
                    });
                }
                Call::ActiveTexture { unit } => gl.active_texture(glow::TEXTURE0 + unit),
                Call::BindTexture { texture } => {
                    let texture = self.maps.get(texture)?;
                    gl.bind_texture(glow::TEXTURE_2D, Some(texture.raw));
                }
                Call::SamplerCompareFunc { func } => {
                    self.samplers.set_comparison(gl, func.number());
                }
                Call::UseProgram { program } => self.programs.choose(gl, program, None)?,
                Call::UseProgramOfSize { program, size } => {
                    self.programs.choose(gl, program, Some(size.known()?))?;
                }
                Call::StencilReference {
                    func,
                    reference,
                    mask,
                } => {
                    gl.stencil_func(func.number(), reference.known()?, mask);
                }
                Call::BlendEquationi { buf, mode } => {
                    gl.blend_equation_draw_buffer(buf, mode.number());
                }
                Call::BlendFunci { buf, src, dst } => {
                    gl.blend_func_draw_buffer(buf, src.number(), dst.number());
                }
                Call::ClearFloats { drawbuffer, value } => {
                    gl.clear_buffer_f32_slice(glow::COLOR, drawbuffer, &value);
                }
                Call::ClearIntegers { drawbuffer } => {
                    gl.clear_buffer_u32_slice(glow::COLOR, drawbuffer, &[0; 4]);
                }
                Call::BindImage { unit, texture } => {
                    let texture = self.maps.get(texture)?;
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
                    self.storages.bind(gl, index, buffer)?;
                }
                Call::MemoryBarrier => gl.memory_barrier(glow::ALL_BARRIER_BITS),
                Call::BindFramebuffer { framebuffer } => self.framebuffers.bind(gl, framebuffer)?,
                Call::AttachColor { texture } => {
                    let raw = Some(self.maps.get(texture)?.raw);
                    gl.framebuffer_texture_2d(
                        glow::FRAMEBUFFER,
                        glow::COLOR_ATTACHMENT0,
                        glow::TEXTURE_2D,
                        raw,
                        0,
                    );
                }
                Call::AttachDepth { texture } => {
                    let texture = self.maps.get(texture)?;
                    gl.framebuffer_texture_2d(
                        glow::FRAMEBUFFER,
                        depth_attachment(Some(texture)),
                        glow::TEXTURE_2D,
                        Some(texture.raw),
                        0,
                    );
                }
                Call::BeginQuery { query } => self.queries.begin(gl, query)?,
                Call::EndQuery { .. } => self.queries.end(gl),
                Call::CopyImage { from, to } => self.maps.copy(self.context, from, to)?,
                Call::Swap { a, b } => self.maps.swap(a, b)?,
                Call::Draw { objects } => self.draw(objects)?,
                Call::Uniform { name, value } => {
                    self.programs.set_uniform(gl, name, value.known()?);
                }
                Call::Classic(ref call) => {
                    let around = Around {
                        context: self.context,
                        maps: &self.maps,
                        samplers: &self.samplers,
                        geometry: self.geometry.as_ref(),
                    };
                    self.classic.perform(call, around)?;
                }
            }
        }
        Ok(())
    }
}

/// Whether a call touches pixels. The others set state, which takes no time.
fn does_work(call: &Call) -> bool {
    matches!(
        call,
        Call::Clear { .. }
            | Call::ClearFloats { .. }
            | Call::ClearIntegers { .. }
            | Call::CopyImage { .. }
            | Call::Draw { .. }
    )
}
