//! The state that classic calls set: matrix stacks, texture units, alpha test. Matrices are f64 until they are used.

use glam::{DMat4, DVec4};

use crate::error::{Error, Result};
use crate::steps::{
    Call, ClassicCall, ClassicCapability, CombinerComponent, CombinerMapping, CombinerRegister,
    Compare, DepthTextureMode, Map, MatrixMode, TexEnvName, TexEnvValue, TextureTarget,
};

/// The number of texture units, as on a GeForce3.
pub const UNITS: usize = 4;

/// The state that classic calls have set.
#[derive(Clone, Debug)]
pub struct ClassicState {
    projection: DMat4,
    mode: MatrixMode,
    modelview: Vec<DMat4>,
    texture: [Vec<DMat4>; UNITS],
    m: DMat4,
    active: usize,
    /// The texture units.
    pub units: [TextureUnit; UNITS],
    /// `GL_TEXTURE_SHADER_NV`: the units' shader operations say what is looked up, instead of what is enabled.
    pub texture_shader: bool,
    /// `GL_REGISTER_COMBINERS_NV`: the combiner makes alpha, and the units' environments have no say.
    pub register_combiners: bool,
    /// The first general combiner's A and B, of which alpha is the product.
    pub combiner: [CombinerInput; 2],
    /// Whether fragments are tested by their alpha.
    pub alpha_test: bool,
    /// The comparison and the reference.
    pub alpha_func: (Compare, f32),
}

/// What a combiner reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CombinerInput {
    /// The register.
    pub register: CombinerRegister,
    /// What is made of it.
    pub mapping: CombinerMapping,
    /// The part of the register.
    pub component: CombinerComponent,
}

/// A texture unit. In GL the depth mode and the comparison belong to a texture; here they are kept with the unit to
/// which it is bound.
#[derive(Clone, Copy, Debug)]
pub struct TextureUnit {
    /// The 2D texture that is looked up, and whether it is enabled. If both are enabled, the rectangle texture is used.
    pub two_d: (Option<Map>, bool),
    /// The same for the rectangle texture.
    pub rectangle: (Option<Map>, bool),
    /// `GL_TEXTURE_ENV_MODE`
    pub environment: TexEnvValue,
    /// `GL_SHADER_OPERATION_NV`
    pub operation: TexEnvValue,
    /// `GL_DEPTH_TEXTURE_MODE`
    pub depth_mode: DepthTextureMode,
    /// `GL_TEXTURE_COMPARE_MODE` is `GL_COMPARE_R_TO_TEXTURE`.
    pub compare: bool,
    /// `GL_TEXTURE_COMPARE_FUNC`
    pub compare_func: Compare,
    /// Whether coordinates are generated.
    pub texgen: bool,
    /// The planes for s, t, r and q, as they are applied to eye coordinates.
    pub eye_planes: [DVec4; 4],
}

impl ClassicState {
    /// OpenGL's initial state, except for the modelview matrix, which is the camera's.
    pub fn new(view: DMat4, projection: DMat4) -> Self {
        let unit = TextureUnit {
            two_d: (None, false),
            rectangle: (None, false),
            environment: TexEnvValue::Modulate,
            operation: TexEnvValue::None,
            depth_mode: DepthTextureMode::Luminance,
            compare: false,
            compare_func: Compare::Lequal,
            texgen: false,
            // OpenGL's own default planes.
            eye_planes: [DVec4::X, DVec4::Y, DVec4::ZERO, DVec4::ZERO],
        };
        Self {
            projection,
            mode: MatrixMode::Modelview,
            modelview: vec![view],
            texture: std::array::from_fn(|_| vec![DMat4::IDENTITY]),
            m: DMat4::IDENTITY,
            active: 0,
            units: [unit; UNITS],
            texture_shader: false,
            register_combiners: false,
            // The primary colour's alpha, times one.
            combiner: [
                CombinerInput {
                    register: CombinerRegister::PrimaryColor,
                    mapping: CombinerMapping::Identity,
                    component: CombinerComponent::Alpha,
                },
                CombinerInput {
                    register: CombinerRegister::Zero,
                    mapping: CombinerMapping::Invert,
                    component: CombinerComponent::Alpha,
                },
            ],
            alpha_test: false,
            alpha_func: (Compare::Always, 0.0),
        }
    }

    /// The modelview matrix.
    pub fn modelview(&self) -> DMat4 {
        *self.modelview.last().expect("a stack is never empty")
    }

    /// A unit's texture matrix.
    pub fn texture_matrix(&self, unit: usize) -> DMat4 {
        *self.texture[unit].last().expect("a stack is never empty")
    }

    /// The texture that a unit looks up.
    pub(super) fn looked_up(&self, unit: usize) -> Option<(TextureTarget, Map)> {
        let unit = &self.units[unit];
        let two_d = |map| (TextureTarget::Texture2D, map);
        let rectangle = |map| (TextureTarget::Rectangle, map);
        match (self.texture_shader, unit.operation) {
            (true, TexEnvValue::Texture2D) => unit.two_d.0.map(two_d),
            (true, TexEnvValue::TextureRectangle) => unit.rectangle.0.map(rectangle),
            (true, _) => None,
            (false, _) => match (unit.rectangle, unit.two_d) {
                ((Some(map), true), _) => Some(rectangle(map)),
                (_, (Some(map), true)) => Some(two_d(map)),
                _ => None,
            },
        }
    }

    /// The stages of Listing 2's two dot products, if they are set up and texture shaders are enabled.
    pub fn depth_replace(&self) -> Option<[usize; 2]> {
        if !self.texture_shader {
            return None;
        }
        let stage = |operation| {
            let units = &mut self.units.iter();
            units.position(|unit| unit.operation == operation)
        };
        Some([
            stage(TexEnvValue::DotProduct)?,
            stage(TexEnvValue::DotProductDepthReplace)?,
        ])
    }

    /// Performs a call.
    ///
    /// # Errors
    /// If OpenGL would refuse the call, or if it is not emulated.
    pub fn perform(&mut self, call: &ClassicCall) -> Result<()> {
        let wrong = |why: &'static str| {
            Err(Error::CannotPerform {
                machine: "the emulation of classic OpenGL",
                call: Call::Classic(*call).to_string(),
                why,
                remedy: "steps::ClassicCall says which calls there are",
            })
        };
        match *call {
            ClassicCall::ActiveTexture { unit } if unit as usize >= UNITS => {
                return wrong("there are four texture units");
            }
            ClassicCall::ActiveTexture { unit } => self.active = unit as usize,
            ClassicCall::BindTexture { target, texture } => match target {
                TextureTarget::Texture2D => self.unit().two_d.0 = Some(texture),
                TextureTarget::Rectangle => self.unit().rectangle.0 = Some(texture),
            },
            // The machine performs this, because there is only one such texture. It also performs copies.
            ClassicCall::BindUnsignedHilo | ClassicCall::CopyToRectangle { .. } => {}
            ClassicCall::Enable { cap } => self.enable(cap, true),
            ClassicCall::Disable { cap } => self.enable(cap, false),
            ClassicCall::AlphaFunc { func, reference } => {
                // GL clamps the reference.
                self.alpha_func = (func, reference.clamp(0.0, 1.0));
            }
            ClassicCall::TexEnv { pname, param, .. } => match pname {
                TexEnvName::TextureEnvMode => self.unit().environment = param,
                TexEnvName::ShaderOperation => self.unit().operation = param,
                TexEnvName::PreviousTextureInput if param == TexEnvValue::Unit(0) => {}
                _ => return wrong("this is not emulated"),
            },
            ClassicCall::CombinerInput {
                variable,
                input,
                mapping,
                component,
            } => {
                self.combiner[variable as usize] = CombinerInput {
                    register: input,
                    mapping,
                    component,
                };
            }
            ClassicCall::DepthTextureMode { mode } => self.unit().depth_mode = mode,
            ClassicCall::TextureCompareMode { on } => self.unit().compare = on,
            ClassicCall::TextureCompareFunc { func } => self.unit().compare_func = func,
            ClassicCall::MatrixMode { mode } => self.mode = mode,
            ClassicCall::PushMatrix => {
                let top = *self.top();
                self.stack().push(top);
            }
            ClassicCall::PopMatrix if self.stack().len() == 1 => {
                return wrong("the stack has one matrix left");
            }
            ClassicCall::PopMatrix => {
                self.stack().pop();
            }
            ClassicCall::LoadIdentity => *self.top() = DMat4::IDENTITY,
            ClassicCall::Translate { x, y, z } => {
                let by = glam::Vec3::new(x, y, z).as_dvec3();
                self.multiply(DMat4::from_translation(by));
            }
            ClassicCall::Scale { x, y, z } => {
                // glam refuses a scale of 0, which Listing 2 has.
                let by = glam::Vec4::new(x, y, z, 1.0).as_dvec4();
                self.multiply(DMat4::from_diagonal(by));
            }
            ClassicCall::ScaleBy { x, y } => {
                let by = glam::Vec4::new(x.known()?, y.known()?, 1.0, 1.0).as_dvec4();
                self.multiply(DMat4::from_diagonal(by));
            }
            ClassicCall::SetM { rows } => {
                let rows = rows.map(|row| row.map(f64::from));
                self.m = DMat4::from_cols_array_2d(&rows).transpose();
            }
            ClassicCall::MultM => self.multiply(self.m),
            ClassicCall::ApplyPerspective => self.multiply(self.projection),
            ClassicCall::EyeLinearTexgen => self.set_planes(DMat4::IDENTITY),
            ClassicCall::EyePlanes { planes } => {
                let rows = planes.map(|plane| plane.map(f64::from));
                self.set_planes(DMat4::from_cols_array_2d(&rows));
            }
            ClassicCall::Texgen { on } => self.unit().texgen = on,
        }
        Ok(())
    }

    /// Each column is a plane. A plane is a row vector, which is multiplied by the inverse of the current modelview
    /// matrix: p M^-1.
    fn set_planes(&mut self, planes: DMat4) {
        let transposed = self.modelview().inverse().transpose();
        let columns = [planes.x_axis, planes.y_axis, planes.z_axis, planes.w_axis];
        self.unit().eye_planes = columns.map(|plane| transposed * plane);
    }

    fn enable(&mut self, cap: ClassicCapability, on: bool) {
        match cap {
            ClassicCapability::AlphaTest => self.alpha_test = on,
            ClassicCapability::Texture2D => self.unit().two_d.1 = on,
            ClassicCapability::TextureRectangle => self.unit().rectangle.1 = on,
            ClassicCapability::TextureShader => self.texture_shader = on,
            ClassicCapability::RegisterCombiners => self.register_combiners = on,
        }
    }

    fn unit(&mut self) -> &mut TextureUnit {
        &mut self.units[self.active]
    }

    fn stack(&mut self) -> &mut Vec<DMat4> {
        match self.mode {
            MatrixMode::Modelview => &mut self.modelview,
            MatrixMode::Texture => &mut self.texture[self.active],
        }
    }

    fn top(&mut self) -> &mut DMat4 {
        self.stack().last_mut().expect("a stack is never empty")
    }

    fn multiply(&mut self, by: DMat4) {
        *self.top() *= by;
    }
}
