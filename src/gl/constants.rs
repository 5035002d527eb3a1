//! GL's constants for the vocabulary's enums.

use crate::steps::{BlendEquation, BlendFactor, Buffers, Capability, Compare, StencilOp};

/// GL's name for an error.
pub(super) fn error_name(error: u32) -> &'static str {
    match error {
        glow::INVALID_ENUM => "GL_INVALID_ENUM",
        glow::INVALID_VALUE => "GL_INVALID_VALUE",
        glow::INVALID_OPERATION => "GL_INVALID_OPERATION",
        glow::INVALID_FRAMEBUFFER_OPERATION => "GL_INVALID_FRAMEBUFFER_OPERATION",
        glow::OUT_OF_MEMORY => "GL_OUT_OF_MEMORY",
        glow::CONTEXT_LOST => "GL_CONTEXT_LOST",
        _ => "an unknown error",
    }
}

/// The bits of `glClear`.
pub(super) fn clear_bits(mask: Buffers) -> u32 {
    let bit = |set, bit| if set { bit } else { 0 };
    bit(mask.color, glow::COLOR_BUFFER_BIT)
        | bit(mask.depth, glow::DEPTH_BUFFER_BIT)
        | bit(mask.stencil, glow::STENCIL_BUFFER_BIT)
}

/// The capability of `glEnable`.
pub(super) const fn capability(cap: Capability) -> u32 {
    match cap {
        Capability::DepthTest => glow::DEPTH_TEST,
        Capability::StencilTest => glow::STENCIL_TEST,
        Capability::Blend => glow::BLEND,
        Capability::DepthClamp => glow::DEPTH_CLAMP,
    }
}

/// A comparison.
pub(super) const fn compare(func: Compare) -> u32 {
    match func {
        Compare::Never => glow::NEVER,
        Compare::Less => glow::LESS,
        Compare::Equal => glow::EQUAL,
        Compare::Lequal => glow::LEQUAL,
        Compare::Greater => glow::GREATER,
        Compare::Notequal => glow::NOTEQUAL,
        Compare::Gequal => glow::GEQUAL,
        Compare::Always => glow::ALWAYS,
    }
}

/// A stencil operation.
pub(super) const fn stencil_op(op: StencilOp) -> u32 {
    match op {
        StencilOp::Keep => glow::KEEP,
        StencilOp::Zero => glow::ZERO,
        StencilOp::Replace => glow::REPLACE,
        StencilOp::Incr => glow::INCR,
        StencilOp::IncrWrap => glow::INCR_WRAP,
        StencilOp::Decr => glow::DECR,
        StencilOp::DecrWrap => glow::DECR_WRAP,
        StencilOp::Invert => glow::INVERT,
    }
}

/// A blend equation.
pub(super) const fn blend_equation(mode: BlendEquation) -> u32 {
    match mode {
        BlendEquation::FuncAdd => glow::FUNC_ADD,
        BlendEquation::Max => glow::MAX,
    }
}

/// A blend factor.
pub(super) const fn blend_factor(factor: BlendFactor) -> u32 {
    match factor {
        BlendFactor::Zero => glow::ZERO,
        BlendFactor::One => glow::ONE,
        BlendFactor::SrcAlpha => glow::SRC_ALPHA,
        BlendFactor::OneMinusSrcAlpha => glow::ONE_MINUS_SRC_ALPHA,
        BlendFactor::DstAlpha => glow::DST_ALPHA,
        BlendFactor::OneMinusDstAlpha => glow::ONE_MINUS_DST_ALPHA,
    }
}
