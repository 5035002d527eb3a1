//! The classic calls under their names, with the constants' `GL_` as Listing 2 prints them. If a core call has the same
//! name (`glEnable`, `glBindTexture`), the classic one has a longer name.

#![allow(non_snake_case, missing_docs)] // GL's own names, and the paper's; the extensions' specifications are their manual

use super::call::Call;
use super::classic::*;
use super::names::Map;

pub use super::call::classic_functions::*;

pub const GL_ALPHA_TEST: ClassicCapability = ClassicCapability::AlphaTest;
pub const GL_TEXTURE_2D: ClassicCapability = ClassicCapability::Texture2D;
pub const GL_TEXTURE_RECTANGLE_NV: ClassicCapability = ClassicCapability::TextureRectangle;
pub const GL_MODELVIEW: MatrixMode = MatrixMode::Modelview;
pub const GL_TEXTURE: MatrixMode = MatrixMode::Texture;
pub const GL_LUMINANCE: DepthTextureMode = DepthTextureMode::Luminance;
pub const GL_INTENSITY: DepthTextureMode = DepthTextureMode::Intensity;
pub const GL_ALPHA: DepthTextureMode = DepthTextureMode::Alpha;
pub const GL_TEXTURE_ENV: TexEnvName = TexEnvName::TextureEnv;
pub const GL_TEXTURE_ENV_MODE: TexEnvName = TexEnvName::TextureEnvMode;
pub const GL_TEXTURE_SHADER_NV: TexEnvName = TexEnvName::TextureShader;
pub const GL_SHADER_OPERATION_NV: TexEnvName = TexEnvName::ShaderOperation;
pub const GL_PREVIOUS_TEXTURE_INPUT_NV: TexEnvName = TexEnvName::PreviousTextureInput;
pub const GL_NONE: TexEnvValue = TexEnvValue::None;
pub const GL_REPLACE: TexEnvValue = TexEnvValue::Replace;
pub const GL_MODULATE: TexEnvValue = TexEnvValue::Modulate;
pub const GL_DOT_PRODUCT_NV: TexEnvValue = TexEnvValue::DotProduct;
pub const GL_DOT_PRODUCT_DEPTH_REPLACE_NV: TexEnvValue = TexEnvValue::DotProductDepthReplace;
/// As a shader operation.
pub const LOOK_UP_TEXTURE_2D: TexEnvValue = TexEnvValue::Texture2D;
/// As a shader operation.
pub const LOOK_UP_TEXTURE_RECTANGLE_NV: TexEnvValue = TexEnvValue::TextureRectangle;
pub const GL_TEXTURE0_ARB: u32 = 0;
pub const GL_TEXTURE1_ARB: u32 = 1;
pub const GL_TEXTURE2_ARB: u32 = 2;
pub const GL_TEXTURE3_ARB: u32 = 3;
/// As a texture input.
pub const FROM_TEXTURE0_ARB: TexEnvValue = TexEnvValue::Unit(0);

pub const fn bind_texture_2d(texture: Map) -> Call {
    bind_texture(TextureTarget::Texture2D, texture)
}

pub const fn bind_texture_rectangle(texture: Map) -> Call {
    bind_texture(TextureTarget::Rectangle, texture)
}

pub const fn enable_texture_shader() -> Call {
    enable_classic(ClassicCapability::TextureShader)
}

pub const fn enable_register_combiners() -> Call {
    enable_classic(ClassicCapability::RegisterCombiners)
}
