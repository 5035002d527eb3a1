//! Listing 1's imaginary OpenGL, on the OpenGL of 2001. [`DepthUnits`](super::DepthUnits) does the same on the OpenGL
//! of today.
//!
//! | listing | depth unit 0 |
//! | --- | --- |
//! | bind buffer | bound to texture unit 3, as Listing 2 leaves it, or copied into a rectangle texture that is bound there |
//! | set depth func | `GL_TEXTURE_COMPARE_FUNC` |
//! | enable, disable depth test | `GL_TEXTURE_2D`, or the rectangle's, and `GL_ALPHA_TEST` together; where texture unit 3 has a shader operation, that operation, or `GL_NONE` |
//! | disable depth writes | nothing to do: a texture is not written |
//!
//! Depth unit 1 is the ordinary depth buffer. Surfaces that would be drawn with the program `peel` are drawn by the
//! emulated fixed functions.

use super::call::{Call, ClassicCall};
use super::classic::{ClassicCapability, TexEnvName, TexEnvValue, TextureTarget};
use super::constants::{Capability, Compare};
use super::depth_units::DepthUnits;
use super::names::{Map, Query, Shader};
use super::walk::{CallLine, Machine};
use crate::error::{Error, Result};

/// A machine with two depth units, made from one with classic calls.
#[derive(Debug)]
pub struct ClassicDepthUnits<'a, M> {
    units: DepthUnits<'a, M>,
    active: u8,
    /// The program that draws in place of `peel`.
    fixed_functions: Shader,
    /// The texture that the shadow map is looked up in.
    target: TextureTarget,
    /// Whether the comparison is SGIX_shadow's, which has LEQUAL and GEQUAL only.
    sgix_shadow: bool,
    texture_unit: u32,
    /// The shader operation that texture unit 3 has been given.
    operation: Option<TexEnvValue>,
}

/// The texture unit with the shadow map.
const SHADOW_UNIT: u32 = 3;
/// The copy of the shadow map that is looked up as a rectangle texture.
const RECTANGLE: Map = Map::named("shadow rectangle");

impl<'a, M: Machine> ClassicDepthUnits<'a, M> {
    /// A machine whose unit 0 tests nothing yet. `fixed_functions` draws surfaces: `classic/fixed` or
    /// `classic/depth_replace`.
    pub fn new(machine: &'a mut M, fixed_functions: Shader) -> Self {
        Self {
            units: DepthUnits::new(machine),
            active: 1,
            fixed_functions,
            target: TextureTarget::Texture2D,
            sgix_shadow: false,
            texture_unit: 0,
            operation: None,
        }
    }

    /// The same with shadow maps in a rectangle texture, whose coordinates are texels.
    #[must_use]
    pub fn with_rectangles(self) -> Self {
        Self {
            target: TextureTarget::Rectangle,
            ..self
        }
    }

    /// The same with the comparisons of SGIX_shadow alone. ARB_shadow and EXT_shadow_funcs of 2002 have the others.
    #[must_use]
    pub fn with_sgix_shadow(self) -> Self {
        Self {
            sgix_shadow: true,
            ..self
        }
    }

    fn classic(&mut self, call: ClassicCall) -> Result<()> {
        match call {
            ClassicCall::ActiveTexture { unit } => self.texture_unit = unit,
            ClassicCall::TexEnv {
                pname: TexEnvName::ShaderOperation,
                param,
                ..
            } if self.texture_unit == SHADOW_UNIT => self.operation = Some(param),
            _ => {}
        }
        self.units.perform(&Call::Classic(call))
    }

    fn unit_0(&mut self, call: &Call) -> Result<()> {
        match *call {
            Call::BindDepthBuffer { buffer } => {
                self.classic(ClassicCall::ActiveTexture { unit: SHADOW_UNIT })?;
                let texture = match self.target {
                    TextureTarget::Texture2D => buffer,
                    TextureTarget::Rectangle => {
                        self.classic(ClassicCall::CopyToRectangle {
                            from: buffer,
                            to: RECTANGLE,
                        })?;
                        RECTANGLE
                    }
                };
                self.classic(ClassicCall::BindTexture {
                    target: self.target,
                    texture,
                })
            }
            Call::DepthFunc { func }
                if self.sgix_shadow && !matches!(func, Compare::Lequal | Compare::Gequal) =>
            {
                Err(Error::CannotPerform {
                    machine: "SGIX_shadow",
                    call: call.to_string(),
                    why: "it compares by GL_LEQUAL and GL_GEQUAL only",
                    remedy: "keep what GL_LEQUAL does not pass, or take the extensions of 2002",
                })
            }
            Call::DepthFunc { func } => self.classic(ClassicCall::TextureCompareFunc { func }),
            Call::Enable {
                cap: Capability::DepthTest,
            } => self.test(self.operation, |cap| ClassicCall::Enable { cap }),
            Call::Disable {
                cap: Capability::DepthTest,
            } => {
                let none = self.operation.map(|_| TexEnvValue::None);
                self.test(none, |cap| ClassicCall::Disable { cap })
            }
            _ => self.units.perform(call),
        }
    }

    fn test(
        &mut self,
        operation: Option<TexEnvValue>,
        call: impl Fn(ClassicCapability) -> ClassicCall,
    ) -> Result<()> {
        self.classic(ClassicCall::ActiveTexture { unit: SHADOW_UNIT })?;
        if let Some(param) = operation {
            self.units.perform(&Call::Classic(ClassicCall::TexEnv {
                target: TexEnvName::TextureShader,
                pname: TexEnvName::ShaderOperation,
                param,
            }))?;
        }
        self.classic(call(match self.target {
            TextureTarget::Texture2D => ClassicCapability::Texture2D,
            TextureTarget::Rectangle => ClassicCapability::TextureRectangle,
        }))?;
        self.classic(call(ClassicCapability::AlphaTest))
    }
}

impl<M: Machine> Machine for ClassicDepthUnits<'_, M> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        match *call {
            Call::ActiveDepthUnit { unit } => {
                self.active = unit;
                // `DepthUnits` checks that the unit exists, and refuses calls that unit 0 cannot perform.
                self.units.perform(call)
            }
            Call::UseProgram {
                program: Shader("peel"),
            } => self.units.perform(&Call::UseProgram {
                program: self.fixed_functions,
            }),
            _ if self.active == 0 => self.unit_0(call),
            Call::Classic(call) => self.classic(call),
            _ => self.units.perform(call),
        }
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.units.samples(query)
    }

    fn follow(&mut self, line: &CallLine) {
        self.units.follow(line);
    }
}
