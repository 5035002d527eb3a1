//! The real fixed functions, on a compatibility profile: each classic call becomes OpenGL's own call.
//!
//! glow has the core profile only, so functions are looked up by name and constants are spelled out.

use std::ffi::{c_float, c_int, c_uint, c_void};

use glow::HasContext;

use super::super::context::Context;
use super::super::geometry::Buffers;
use super::super::machine::GlMachine;
use crate::error::{Error, Result};
use crate::steps::{
    Call, ClassicCall, ClassicCapability, DepthTextureMode, Machine, Map, MatrixMode, Objects,
    Query, TexEnvName, TexEnvValue, TextureTarget,
};

const ALPHA_TEST: u32 = 0x0BC0;
const MODELVIEW: u32 = 0x1700;
const PROJECTION: u32 = 0x1701;
const TEXTURE: u32 = 0x1702;
const TEXTURE_ENV: u32 = 0x2300;
const TEXTURE_ENV_MODE: u32 = 0x2200;
const MODULATE: u32 = 0x2100;
const S: u32 = 0x2000;
const TEXTURE_GEN_MODE: u32 = 0x2500;
const TEXTURE_GEN_S: u32 = 0x0C60;
const EYE_PLANE: u32 = 0x2502;
const EYE_LINEAR: u32 = 0x2400;
const DEPTH_TEXTURE_MODE: u32 = 0x884B;
const LUMINANCE: u32 = 0x1909;
const INTENSITY: u32 = 0x8049;
const ALPHA: u32 = 0x1906;
const VERTEX_ARRAY: u32 = 0x8074;
const COLOR_ARRAY: u32 = 0x8076;
const UNITS: u32 = 4;

/// A machine that gives classic calls to the driver, and all others to the GL machine inside.
#[derive(Debug)]
pub struct FixedFunction<'m, 'c> {
    machine: &'m mut GlMachine<'c>,
    functions: Functions,
    active: u32,
    target: [TextureTarget; UNITS as usize],
    m: [f32; 16],
}

impl<'m, 'c> FixedFunction<'m, 'c> {
    /// A machine with OpenGL's initial state, except for the matrices, which are the camera's. `machine` must have its
    /// scene, and a context of the compatibility profile.
    ///
    /// # Errors
    /// If the context has no fixed functions, or there is no scene yet.
    pub fn new(machine: &'m mut GlMachine<'c>) -> Result<Self> {
        let functions = Functions::load(machine.context())?;
        let (view, projection) = match &machine.geometry {
            Some(geometry) => (geometry.view.as_mat4(), geometry.projection.as_mat4()),
            None => {
                return Err(Error::out_of_order(
                    "the fixed functions are asked for before there is a camera",
                    "set_geometry first",
                ));
            }
        };
        let gl = machine.context().glow();
        // SAFETY: the context is current, and has these functions and constants, being of the compatibility profile.
        unsafe {
            for unit in 0..UNITS {
                gl.active_texture(glow::TEXTURE0 + unit);
                // A sampler would override the texture's own parameters.
                gl.bind_sampler(unit, None);
                gl.disable(glow::TEXTURE_2D);
                gl.disable(glow::TEXTURE_RECTANGLE);
                (functions.tex_env)(TEXTURE_ENV, TEXTURE_ENV_MODE, MODULATE as c_int);
                (functions.matrix_mode)(TEXTURE);
                (functions.load_identity)();
                for coordinate in 0..4 {
                    gl.disable(TEXTURE_GEN_S + coordinate);
                }
            }
            gl.active_texture(glow::TEXTURE0);
            gl.disable(ALPHA_TEST);
            (functions.matrix_mode)(PROJECTION);
            (functions.load_matrix)(projection.to_cols_array().as_ptr());
            (functions.matrix_mode)(MODELVIEW);
            (functions.load_matrix)(view.to_cols_array().as_ptr());
        }
        Ok(Self {
            machine,
            functions,
            active: 0,
            target: [TextureTarget::Texture2D; UNITS as usize],
            m: [0.0; 16],
        })
    }

    fn classic(&mut self, call: &ClassicCall) -> Result<()> {
        let gl = self.machine.context().glow();
        let f = &self.functions;
        let bound = self.target[self.active as usize];
        // SAFETY: the context is current and of the compatibility profile; constants are OpenGL's own, textures the
        // machine's, and each array has as many elements as its function reads.
        unsafe {
            match *call {
                ClassicCall::ActiveTexture { unit } => {
                    self.active = unit;
                    gl.active_texture(glow::TEXTURE0 + unit);
                }
                ClassicCall::BindTexture { target, texture } => {
                    self.target[self.active as usize] = target;
                    let raw = self.raw(target, texture)?;
                    gl.bind_texture(constant(target), Some(raw));
                    for (name, value) in [
                        (glow::TEXTURE_MIN_FILTER, glow::NEAREST),
                        (glow::TEXTURE_MAG_FILTER, glow::NEAREST),
                        (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
                        (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
                    ] {
                        gl.tex_parameter_i32(constant(target), name, value as i32);
                    }
                }
                ClassicCall::Enable { cap } => gl.enable(capability(*call, cap)?),
                ClassicCall::Disable { cap } => gl.disable(capability(*call, cap)?),
                ClassicCall::AlphaFunc { func, reference } => {
                    (f.alpha_func)(func.number(), reference);
                }
                ClassicCall::TexEnv {
                    pname: TexEnvName::TextureEnvMode,
                    param: param @ (TexEnvValue::Replace | TexEnvValue::Modulate),
                    ..
                } => {
                    let mode = if param == TexEnvValue::Replace {
                        glow::REPLACE
                    } else {
                        MODULATE
                    };
                    (f.tex_env)(TEXTURE_ENV, TEXTURE_ENV_MODE, mode as c_int);
                }
                ClassicCall::TexEnv { .. }
                | ClassicCall::BindUnsignedHilo
                | ClassicCall::CombinerInput { .. } => return Err(of_a_geforce3(*call)),
                ClassicCall::DepthTextureMode { mode } => {
                    let mode = match mode {
                        DepthTextureMode::Luminance => LUMINANCE,
                        DepthTextureMode::Intensity => INTENSITY,
                        DepthTextureMode::Alpha => ALPHA,
                    };
                    gl.tex_parameter_i32(constant(bound), DEPTH_TEXTURE_MODE, mode as i32);
                }
                ClassicCall::TextureCompareMode { on } => {
                    let mode = if on {
                        glow::COMPARE_REF_TO_TEXTURE
                    } else {
                        glow::NONE
                    };
                    let name = glow::TEXTURE_COMPARE_MODE;
                    gl.tex_parameter_i32(constant(bound), name, mode as i32);
                }
                ClassicCall::TextureCompareFunc { func } => {
                    let name = glow::TEXTURE_COMPARE_FUNC;
                    gl.tex_parameter_i32(constant(bound), name, func.number() as i32);
                }
                ClassicCall::MatrixMode { mode } => (f.matrix_mode)(match mode {
                    MatrixMode::Modelview => MODELVIEW,
                    MatrixMode::Texture => TEXTURE,
                }),
                ClassicCall::PushMatrix => (f.push_matrix)(),
                ClassicCall::PopMatrix => (f.pop_matrix)(),
                ClassicCall::LoadIdentity => (f.load_identity)(),
                ClassicCall::Translate { x, y, z } => (f.translate)(x, y, z),
                ClassicCall::Scale { x, y, z } => (f.scale)(x, y, z),
                ClassicCall::ScaleBy { x, y } => (f.scale)(x.known()?, y.known()?, 1.0),
                ClassicCall::SetM { rows } => {
                    let matrix = glam::Mat4::from_cols_array_2d(&rows).transpose();
                    self.m = matrix.to_cols_array();
                }
                ClassicCall::MultM => (f.mult_matrix)(self.m.as_ptr()),
                ClassicCall::ApplyPerspective => {
                    let geometry = self.machine.geometry.as_ref();
                    let projection = geometry.map(|geometry| geometry.projection.as_mat4());
                    let projection = projection.unwrap_or_default().to_cols_array();
                    (f.mult_matrix)(projection.as_ptr());
                }
                ClassicCall::EyeLinearTexgen => {
                    self.eye_planes(&glam::Mat4::IDENTITY.to_cols_array_2d());
                }
                ClassicCall::EyePlanes { planes } => self.eye_planes(&planes),
                ClassicCall::Texgen { on } => {
                    for coordinate in TEXTURE_GEN_S..TEXTURE_GEN_S + 4 {
                        if on {
                            gl.enable(coordinate);
                        } else {
                            gl.disable(coordinate);
                        }
                    }
                }
                ClassicCall::CopyToRectangle { from, to } => {
                    let machine = &mut *self.machine;
                    let (context, maps) = (machine.context, &machine.maps);
                    machine.classic.copy_to_rectangle(context, maps, from, to)?;
                    self.machine
                        .context()
                        .glow()
                        .active_texture(glow::TEXTURE0 + self.active);
                }
            }
        }
        Ok(())
    }

    fn eye_planes(&self, planes: &[[f32; 4]; 4]) {
        for (coordinate, plane) in (S..).zip(planes) {
            // SAFETY: the context is current; a plane has four numbers.
            unsafe {
                (self.functions.tex_gen_i)(coordinate, TEXTURE_GEN_MODE, EYE_LINEAR as c_int);
                (self.functions.tex_gen_fv)(coordinate, EYE_PLANE, plane.as_ptr());
            }
        }
    }

    fn raw(&self, target: TextureTarget, texture: Map) -> Result<glow::Texture> {
        match target {
            TextureTarget::Texture2D => Ok(self.machine.maps.get(texture)?.raw),
            TextureTarget::Rectangle => self.machine.classic.rectangle(texture),
        }
    }

    fn draw(&self, objects: Objects) {
        let gl = self.machine.context().glow();
        let Some(geometry) = &self.machine.geometry else {
            return;
        };
        let f = &self.functions;
        // SAFETY: the context is current; both arrays lie in the bound buffer, as it was filled, and
        // every index is below the number of its vertices.
        unsafe {
            gl.use_program(None);
            gl.bind_vertex_array(None);
            (f.enable_client_state)(VERTEX_ARRAY);
            (f.enable_client_state)(COLOR_ARRAY);
            for buffers in geometry.buffers(objects) {
                let stride = Buffers::STRIDE as c_int;
                gl.bind_buffer(glow::ARRAY_BUFFER, Some(buffers.vertices));
                gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(buffers.indices));
                (f.vertex_pointer)(3, glow::FLOAT, stride, std::ptr::null());
                (f.color_pointer)(4, glow::FLOAT, stride, Buffers::COLOR as *const c_void);
                let offset = buffers.first * 4;
                gl.draw_elements(glow::TRIANGLES, buffers.count, glow::UNSIGNED_INT, offset);
            }
            (f.disable_client_state)(VERTEX_ARRAY);
            (f.disable_client_state)(COLOR_ARRAY);
            gl.bind_buffer(glow::ARRAY_BUFFER, None);
            gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, None);
        }
    }
}

impl Machine for FixedFunction<'_, '_> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        match call {
            Call::Classic(classic) => {
                self.classic(classic)?;
                // SAFETY: the context is current.
                match unsafe { self.machine.context().glow().get_error() } {
                    glow::NO_ERROR => Ok(()),
                    error => Err(Error::Step {
                        step: call.to_string(),
                        error: super::super::constants::error_name(error).into(),
                    }),
                }
            }
            // Fixed functions have no program.
            Call::UseProgram { .. } => Ok(()),
            Call::Draw {
                objects: objects @ (Objects::Scene | Objects::Opaque | Objects::Transparent),
            } => {
                self.draw(*objects);
                Ok(())
            }
            _ => self.machine.perform(call),
        }
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.machine.samples(query)
    }
}

impl Drop for FixedFunction<'_, '_> {
    /// The alpha test would otherwise also test the draws of programs.
    fn drop(&mut self) {
        // SAFETY: the context is current.
        unsafe { self.machine.context().glow().disable(ALPHA_TEST) };
    }
}

const fn constant(target: TextureTarget) -> u32 {
    match target {
        TextureTarget::Texture2D => glow::TEXTURE_2D,
        TextureTarget::Rectangle => glow::TEXTURE_RECTANGLE,
    }
}

fn capability(call: ClassicCall, cap: ClassicCapability) -> Result<u32> {
    match cap {
        ClassicCapability::AlphaTest => Ok(ALPHA_TEST),
        ClassicCapability::Texture2D => Ok(glow::TEXTURE_2D),
        ClassicCapability::TextureRectangle => Ok(glow::TEXTURE_RECTANGLE),
        ClassicCapability::TextureShader | ClassicCapability::RegisterCombiners => {
            Err(of_a_geforce3(call))
        }
    }
}

fn of_a_geforce3(call: ClassicCall) -> Error {
    Error::CannotPerform {
        machine: "OpenGL",
        call: Call::Classic(call).to_string(),
        why: "no driver of today has NV_texture_shader or NV_register_combiners",
        remedy: "the emulation has it: give the call to GlMachine",
    }
}

type Nothing = unsafe extern "system" fn();
type Enum = unsafe extern "system" fn(c_uint);
type Floats3 = unsafe extern "system" fn(c_float, c_float, c_float);
type Floats = unsafe extern "system" fn(*const c_float);
type EnumFloat = unsafe extern "system" fn(c_uint, c_float);
type EnumEnumInt = unsafe extern "system" fn(c_uint, c_uint, c_int);
type EnumEnumFloats = unsafe extern "system" fn(c_uint, c_uint, *const c_float);
type Pointer = unsafe extern "system" fn(c_int, c_uint, c_int, *const c_void);

/// The functions of OpenGL 1.1 that core profiles dropped.
#[derive(Debug)]
struct Functions {
    alpha_func: EnumFloat,
    matrix_mode: Enum,
    push_matrix: Nothing,
    pop_matrix: Nothing,
    load_identity: Nothing,
    load_matrix: Floats,
    mult_matrix: Floats,
    translate: Floats3,
    scale: Floats3,
    tex_env: EnumEnumInt,
    tex_gen_i: EnumEnumInt,
    tex_gen_fv: EnumEnumFloats,
    enable_client_state: Enum,
    disable_client_state: Enum,
    vertex_pointer: Pointer,
    color_pointer: Pointer,
}

impl Functions {
    fn load(context: &Context) -> Result<Self> {
        if !context.driver().has_fixed_functions {
            return Err(Error::Driver {
                what: "this context has no fixed functions: it is of the core profile".into(),
                remedy: "make one with Profile::Compatibility".into(),
            });
        }
        macro_rules! look_up {
            ($name:literal as $kind:ty) => {{
                let function = context.function($name);
                if function.is_null() {
                    return Err(Error::Driver {
                        what: format!("this driver has no {}", $name),
                        remedy: "make a context with Profile::Compatibility on Mesa".into(),
                    });
                }
                // SAFETY: the OpenGL specification gives the function of that name this signature.
                unsafe { std::mem::transmute::<*const c_void, $kind>(function) }
            }};
        }
        Ok(Self {
            alpha_func: look_up!("glAlphaFunc" as EnumFloat),
            matrix_mode: look_up!("glMatrixMode" as Enum),
            push_matrix: look_up!("glPushMatrix" as Nothing),
            pop_matrix: look_up!("glPopMatrix" as Nothing),
            load_identity: look_up!("glLoadIdentity" as Nothing),
            load_matrix: look_up!("glLoadMatrixf" as Floats),
            mult_matrix: look_up!("glMultMatrixf" as Floats),
            translate: look_up!("glTranslatef" as Floats3),
            scale: look_up!("glScalef" as Floats3),
            tex_env: look_up!("glTexEnvi" as EnumEnumInt),
            tex_gen_i: look_up!("glTexGeni" as EnumEnumInt),
            tex_gen_fv: look_up!("glTexGenfv" as EnumEnumFloats),
            enable_client_state: look_up!("glEnableClientState" as Enum),
            disable_client_state: look_up!("glDisableClientState" as Enum),
            vertex_pointer: look_up!("glVertexPointer" as Pointer),
            color_pointer: look_up!("glColorPointer" as Pointer),
        })
    }
}
