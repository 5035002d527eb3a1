//! The OpenGL of 2001: what core profiles no longer have, under its own names.
//!
//! Alpha test, texture coordinate generation and texture matrices, depth textures and their comparison (ARB_shadow,
//! SGIX_shadow before it), rectangle textures, the texture environment, and the part of NV_texture_shader that
//! Everitt's Listing 2 uses. `gl::GlMachine` emulates these calls in GLSL; `gl::FixedFunction` gives them to a
//! compatibility profile that still has them.

use super::call::{Compare, Map};

/// What the classic `glEnable` turns on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum ClassicCapability {
    AlphaTest,
    Texture2D,
    TextureRectangle,
    TextureShader,
}

/// What kind of texture a unit looks up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureTarget {
    /// Coordinates from 0 to 1.
    Texture2D,
    /// Coordinates in texels (NV_texture_rectangle, later ARB_texture_rectangle).
    Rectangle,
}

/// First and second arguments of `glTexEnvi`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum TexEnvName {
    TextureEnv,
    TextureEnvMode,
    TextureShader,
    ShaderOperation,
    PreviousTextureInput,
}

/// Third argument of `glTexEnvi`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum TexEnvValue {
    None,
    Replace,
    Modulate,
    Texture2D,
    TextureRectangle,
    DotProduct,
    DotProductDepthReplace,
    Unit(u32),
}

/// What a depth texture's value becomes (`GL_DEPTH_TEXTURE_MODE`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthTextureMode {
    /// (D, D, D, 1)
    #[default]
    Luminance,
    /// (D, D, D, D)
    Intensity,
    /// (0, 0, 0, D)
    Alpha,
}

/// Which matrix stack the matrix calls go to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum MatrixMode {
    #[default]
    Modelview,
    Texture,
}

/// One call.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // OpenGL's calls and its parameters' names; what OpenGL does not have is documented
pub enum ClassicCall {
    ActiveTexture {
        unit: u32,
    },
    BindTexture {
        target: TextureTarget,
        texture: Map,
    },
    /// The paper's `simple_1x1_uhilo.bind()`: one texel of GL_UNSIGNED_HILO_NV, both of its numbers 0.
    BindUnsignedHilo,
    Enable {
        cap: ClassicCapability,
    },
    Disable {
        cap: ClassicCapability,
    },
    AlphaFunc {
        func: Compare,
        reference: f32,
    },
    TexEnv {
        target: TexEnvName,
        pname: TexEnvName,
        param: TexEnvValue,
    },
    /// `glTexParameteri` with `GL_DEPTH_TEXTURE_MODE`.
    DepthTextureMode {
        mode: DepthTextureMode,
    },
    /// `glTexParameteri` with `GL_TEXTURE_COMPARE_MODE`: `GL_COMPARE_R_TO_TEXTURE` or `GL_NONE`.
    TextureCompareMode {
        on: bool,
    },
    /// `glTexParameteri` with `GL_TEXTURE_COMPARE_FUNC`.
    TextureCompareFunc {
        func: Compare,
    },
    MatrixMode {
        mode: MatrixMode,
    },
    PushMatrix,
    PopMatrix,
    LoadIdentity,
    Translate {
        x: f32,
        y: f32,
        z: f32,
    },
    Scale {
        x: f32,
        y: f32,
        z: f32,
    },
    /// The paper's `m(0,0) = ...`: sixteen assignments, row by row.
    SetM {
        rows: [[f32; 4]; 4],
    },
    /// The paper's `glMultMatrix(m)`.
    MultM,
    /// The paper's `reshaper.apply_perspective()`: multiplies by the camera's projection.
    ApplyPerspective,
    /// The paper's `eye_linear_texgen()`: on all four coordinates EYE_LINEAR with the identity's planes.
    EyeLinearTexgen,
    /// EYE_LINEAR on all four coordinates with these planes, for s, t, r and q.
    EyePlanes {
        planes: [[f32; 4]; 4],
    },
    /// The paper's `texgen(true)`: enables generation of all four coordinates.
    Texgen {
        on: bool,
    },
    /// `glCopyTexSubImage2D` of a whole depth buffer into a rectangle texture of its size and format, made if it is not
    /// there.
    CopyToRectangle {
        from: Map,
        to: Map,
    },
}

impl ClassicCall {
    /// The call's name in GL or in the paper, and its arguments' names and values.
    pub(super) fn signature(&self) -> (&'static str, Vec<(&'static str, String)>) {
        let gl = |func| format!("GL_{}", super::signature::compare(func));
        let parameter = |pname: &str, param: String| {
            let arguments = vec![
                ("target", "GL_TEXTURE_2D".into()),
                ("pname", pname.to_owned()),
                ("param", param),
            ];
            ("glTexParameteri", arguments)
        };
        let xyz = |x: f32, y: f32, z: f32| {
            let text = |value: f32| value.to_string();
            vec![("x", text(x)), ("y", text(y)), ("z", text(z))]
        };
        match *self {
            Self::ActiveTexture { unit } => {
                let unit = format!("GL_TEXTURE{unit}_ARB");
                ("glActiveTextureARB", vec![("texture", unit)])
            }
            Self::BindTexture { target, texture } => (
                "glBindTexture",
                vec![
                    ("target", target.name().into()),
                    ("texture", texture.to_string()),
                ],
            ),
            Self::BindUnsignedHilo => ("simple_1x1_uhilo.bind", vec![]),
            Self::Enable { cap } => ("glEnable", vec![("cap", cap.name().into())]),
            Self::Disable { cap } => ("glDisable", vec![("cap", cap.name().into())]),
            Self::AlphaFunc { func, reference } => (
                "glAlphaFunc",
                vec![("func", gl(func)), ("ref", reference.to_string())],
            ),
            Self::TexEnv {
                target,
                pname,
                param,
            } => (
                "glTexEnvi",
                vec![
                    ("target", target.name().into()),
                    ("pname", pname.name().into()),
                    ("param", param.name()),
                ],
            ),
            Self::DepthTextureMode { mode } => {
                let mode = match mode {
                    DepthTextureMode::Luminance => "GL_LUMINANCE",
                    DepthTextureMode::Intensity => "GL_INTENSITY",
                    DepthTextureMode::Alpha => "GL_ALPHA",
                };
                parameter("GL_DEPTH_TEXTURE_MODE", mode.into())
            }
            Self::TextureCompareMode { on } => {
                let mode = if on {
                    "GL_COMPARE_R_TO_TEXTURE"
                } else {
                    "GL_NONE"
                };
                parameter("GL_TEXTURE_COMPARE_MODE", mode.into())
            }
            Self::TextureCompareFunc { func } => parameter("GL_TEXTURE_COMPARE_FUNC", gl(func)),
            Self::MatrixMode { mode } => {
                let mode = match mode {
                    MatrixMode::Modelview => "GL_MODELVIEW",
                    MatrixMode::Texture => "GL_TEXTURE",
                };
                ("glMatrixMode", vec![("mode", mode.into())])
            }
            Self::PushMatrix => ("glPushMatrix", vec![]),
            Self::PopMatrix => ("glPopMatrix", vec![]),
            Self::LoadIdentity => ("glLoadIdentity", vec![]),
            Self::Translate { x, y, z } => ("glTranslatef", xyz(x, y, z)),
            Self::Scale { x, y, z } => ("glScalef", xyz(x, y, z)),
            Self::SetM { rows } => ("m", vec![("rows", format!("{rows:?}"))]),
            Self::MultM => ("glMultMatrix", vec![("m", "m".into())]),
            Self::ApplyPerspective => ("reshaper.apply_perspective", vec![]),
            Self::EyeLinearTexgen => ("eye_linear_texgen", vec![]),
            Self::EyePlanes { planes } => {
                ("eye_linear_texgen", vec![("planes", format!("{planes:?}"))])
            }
            Self::Texgen { on } => ("texgen", vec![("on", on.to_string())]),
            Self::CopyToRectangle { from, to } => (
                "glCopyTexSubImage2D",
                vec![
                    ("target", TextureTarget::Rectangle.name().into()),
                    ("from", from.to_string()),
                    ("to", to.to_string()),
                ],
            ),
        }
    }

    /// The call as C source that keeps `GL_`, as Listing 2 prints it.
    pub(super) fn source(&self) -> String {
        if let Self::SetM { rows } = self {
            let lines = rows.iter().enumerate().map(|(row, values)| {
                let sets = values.iter().enumerate();
                let sets: Vec<_> = sets
                    .map(|(column, value)| format!("m({row},{column}) = {value};"))
                    .collect();
                sets.join("   ")
            });
            return lines.collect::<Vec<_>>().join("\n");
        }
        let (name, arguments) = self.signature();
        let values: Vec<_> = arguments.into_iter().map(|(_, value)| value).collect();
        format!("{name}({});", values.join(", "))
    }
}

impl TextureTarget {
    const fn name(self) -> &'static str {
        match self {
            Self::Texture2D => "GL_TEXTURE_2D",
            Self::Rectangle => "GL_TEXTURE_RECTANGLE_NV",
        }
    }
}

impl ClassicCapability {
    const fn name(self) -> &'static str {
        match self {
            Self::AlphaTest => "GL_ALPHA_TEST",
            Self::Texture2D => "GL_TEXTURE_2D",
            Self::TextureRectangle => "GL_TEXTURE_RECTANGLE_NV",
            Self::TextureShader => "GL_TEXTURE_SHADER_NV",
        }
    }
}

impl TexEnvName {
    const fn name(self) -> &'static str {
        match self {
            Self::TextureEnv => "GL_TEXTURE_ENV",
            Self::TextureEnvMode => "GL_TEXTURE_ENV_MODE",
            Self::TextureShader => "GL_TEXTURE_SHADER_NV",
            Self::ShaderOperation => "GL_SHADER_OPERATION_NV",
            Self::PreviousTextureInput => "GL_PREVIOUS_TEXTURE_INPUT_NV",
        }
    }
}

impl TexEnvValue {
    fn name(self) -> String {
        match self {
            Self::None => "GL_NONE".into(),
            Self::Replace => "GL_REPLACE".into(),
            Self::Modulate => "GL_MODULATE".into(),
            Self::Texture2D => "GL_TEXTURE_2D".into(),
            Self::TextureRectangle => "GL_TEXTURE_RECTANGLE_NV".into(),
            Self::DotProduct => "GL_DOT_PRODUCT_NV".into(),
            Self::DotProductDepthReplace => "GL_DOT_PRODUCT_DEPTH_REPLACE_NV".into(),
            Self::Unit(unit) => format!("GL_TEXTURE{unit}_ARB"),
        }
    }
}
