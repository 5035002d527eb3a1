//! The classic calls under their names, with the constants' `GL_` as Listing 2 prints them. Where a core call has the
//! name already (`glEnable`, `glBindTexture`), the classic one says so in its own.

#![allow(non_snake_case, missing_docs)] // GL's own names, and the paper's; the extensions' specifications are their manual

use super::call::{Call, Compare, Map};
use super::classic::*;
use super::listing::Step;

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

const fn classic(call: ClassicCall) -> Step {
    Step::Call(Call::Classic(call))
}

pub const fn glActiveTextureARB(unit: u32) -> Step {
    classic(ClassicCall::ActiveTexture { unit })
}

pub const fn bind_texture_2d(texture: Map) -> Step {
    classic(ClassicCall::BindTexture {
        target: TextureTarget::Texture2D,
        texture,
    })
}

pub const fn bind_texture_rectangle(texture: Map) -> Step {
    classic(ClassicCall::BindTexture {
        target: TextureTarget::Rectangle,
        texture,
    })
}

pub const fn bind_simple_1x1_uhilo() -> Step {
    classic(ClassicCall::BindUnsignedHilo)
}

pub const fn enable_classic(cap: ClassicCapability) -> Step {
    classic(ClassicCall::Enable { cap })
}

pub const fn disable_classic(cap: ClassicCapability) -> Step {
    classic(ClassicCall::Disable { cap })
}

pub const fn enable_texture_shader() -> Step {
    enable_classic(ClassicCapability::TextureShader)
}

pub const fn glAlphaFunc(func: Compare, reference: f32) -> Step {
    classic(ClassicCall::AlphaFunc { func, reference })
}

pub const fn glTexEnvi(target: TexEnvName, pname: TexEnvName, param: TexEnvValue) -> Step {
    classic(ClassicCall::TexEnv {
        target,
        pname,
        param,
    })
}

pub const fn depth_texture_mode(mode: DepthTextureMode) -> Step {
    classic(ClassicCall::DepthTextureMode { mode })
}

pub const fn compare_r_to_texture(on: bool) -> Step {
    classic(ClassicCall::TextureCompareMode { on })
}

pub const fn texture_compare_func(func: Compare) -> Step {
    classic(ClassicCall::TextureCompareFunc { func })
}

pub const fn glMatrixMode(mode: MatrixMode) -> Step {
    classic(ClassicCall::MatrixMode { mode })
}

pub const fn glPushMatrix() -> Step {
    classic(ClassicCall::PushMatrix)
}

pub const fn glPopMatrix() -> Step {
    classic(ClassicCall::PopMatrix)
}

pub const fn glLoadIdentity() -> Step {
    classic(ClassicCall::LoadIdentity)
}

pub const fn glTranslatef(x: f32, y: f32, z: f32) -> Step {
    classic(ClassicCall::Translate { x, y, z })
}

pub const fn glScalef(x: f32, y: f32, z: f32) -> Step {
    classic(ClassicCall::Scale { x, y, z })
}

pub const fn m(rows: [[f32; 4]; 4]) -> Step {
    classic(ClassicCall::SetM { rows })
}

pub const fn glMultMatrix_m() -> Step {
    classic(ClassicCall::MultM)
}

pub const fn apply_perspective() -> Step {
    classic(ClassicCall::ApplyPerspective)
}

pub const fn eye_linear_texgen() -> Step {
    classic(ClassicCall::EyeLinearTexgen)
}

pub const fn texgen(on: bool) -> Step {
    classic(ClassicCall::Texgen { on })
}

pub const fn glCopyTexSubImage2D(from: Map, to: Map) -> Step {
    classic(ClassicCall::CopyToRectangle { from, to })
}
