//! The OpenGL of 2001: calls that core profiles no longer have, under their own names.
//!
//! Alpha test, texture coordinate generation and texture matrices, depth textures and their comparison (ARB_shadow,
//! SGIX_shadow before it), rectangle textures, the texture environment, the part of NV_texture_shader that Everitt's
//! Listing 2 uses, and as much of NV_register_combiners as carries a texture's colour into alpha. `gl::GlMachine` emulates these calls in GLSL; `gl::FixedFunction` gives them to a
//! compatibility profile that still has them.

use super::argument::Argument;
use super::constants::constants;

constants! {
    /// The capabilities of the classic `glEnable`.
    ClassicCapability {
        AlphaTest = "ALPHA_TEST",
        Texture2D = "TEXTURE_2D",
        TextureRectangle = "TEXTURE_RECTANGLE_NV",
        TextureShader = "TEXTURE_SHADER_NV",
        RegisterCombiners = "REGISTER_COMBINERS_NV",
    }

    /// An input of the first general combiner. Its result is the product of A and B.
    CombinerVariable {
        A = "VARIABLE_A_NV",
        B = "VARIABLE_B_NV",
    }

    /// A register that a combiner reads.
    CombinerRegister {
        Zero = "ZERO",
        PrimaryColor = "PRIMARY_COLOR_NV",
        Texture0 = "TEXTURE0_ARB",
        Texture1 = "TEXTURE1_ARB",
        Texture2 = "TEXTURE2_ARB",
        Texture3 = "TEXTURE3_ARB",
    }

    /// What a combiner makes of what it reads.
    CombinerMapping {
        /// max(0, x)
        Identity = "UNSIGNED_IDENTITY_NV",
        /// 1 - min(max(x, 0), 1)
        Invert = "UNSIGNED_INVERT_NV",
    }

    /// The part of a register that an alpha combiner reads.
    CombinerComponent {
        Blue = "BLUE",
        Alpha = "ALPHA",
    }

    /// The kind of texture that a unit looks up.
    TextureTarget {
        /// Coordinates from 0 to 1.
        Texture2D = "TEXTURE_2D",
        /// Coordinates in texels (NV_texture_rectangle, later ARB_texture_rectangle).
        Rectangle = "TEXTURE_RECTANGLE_NV",
    }

    /// First and second arguments of `glTexEnvi`.
    TexEnvName {
        TextureEnv = "TEXTURE_ENV",
        TextureEnvMode = "TEXTURE_ENV_MODE",
        TextureShader = "TEXTURE_SHADER_NV",
        ShaderOperation = "SHADER_OPERATION_NV",
        PreviousTextureInput = "PREVIOUS_TEXTURE_INPUT_NV",
    }

    /// The colour of a depth texture's value (`GL_DEPTH_TEXTURE_MODE`).
    #[derive(Default)]
    DepthTextureMode {
        /// (D, D, D, 1)
        #[default]
        Luminance = "LUMINANCE",
        /// (D, D, D, D)
        Intensity = "INTENSITY",
        /// (0, 0, 0, D)
        Alpha = "ALPHA",
    }

    /// The matrix stack to which matrix calls go.
    #[derive(Default)]
    MatrixMode {
        #[default]
        Modelview = "MODELVIEW",
        Texture = "TEXTURE",
    }
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

impl Argument for TexEnvValue {
    fn text(&self) -> String {
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
