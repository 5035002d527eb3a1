//! OpenGL's calls and constants under OpenGL's names, so that a listing reads like the paper's.
//!
//! Each function only makes the [`Call`]; nothing here calls GL. Most come from the table of calls. Constants stand
//! without their `GL_`, as Carr et al. print them.

#![allow(non_snake_case, missing_docs)] // GL's own names; the GL specification is their manual

use super::call::Call;
use super::constants::*;
use super::names::{Number, Shader};

pub use super::call::functions::*;
pub use super::gl_classic::*;

pub const NEVER: Compare = Compare::Never;
pub const LESS: Compare = Compare::Less;
pub const EQUAL: Compare = Compare::Equal;
pub const LEQUAL: Compare = Compare::Lequal;
pub const GREATER: Compare = Compare::Greater;
pub const NOTEQUAL: Compare = Compare::Notequal;
pub const GEQUAL: Compare = Compare::Gequal;
pub const ALWAYS: Compare = Compare::Always;

pub const KEEP: StencilOp = StencilOp::Keep;
pub const REPLACE: StencilOp = StencilOp::Replace;
pub const INCR: StencilOp = StencilOp::Incr;
pub const INCR_WRAP: StencilOp = StencilOp::IncrWrap;
pub const DECR: StencilOp = StencilOp::Decr;
pub const DECR_WRAP: StencilOp = StencilOp::DecrWrap;
pub const INVERT: StencilOp = StencilOp::Invert;

pub const ZERO: BlendFactor = BlendFactor::Zero;
pub const ONE: BlendFactor = BlendFactor::One;
pub const SRC_ALPHA: BlendFactor = BlendFactor::SrcAlpha;
pub const ONE_MINUS_SRC_ALPHA: BlendFactor = BlendFactor::OneMinusSrcAlpha;
pub const DST_ALPHA: BlendFactor = BlendFactor::DstAlpha;
/// Carr et al.'s name for it.
pub const DEST_ALPHA: BlendFactor = BlendFactor::DstAlpha;
pub const ONE_MINUS_DST_ALPHA: BlendFactor = BlendFactor::OneMinusDstAlpha;

pub const FUNC_ADD: BlendEquation = BlendEquation::FuncAdd;
pub const MAX: BlendEquation = BlendEquation::Max;

pub const DEPTH_TEST: Capability = Capability::DepthTest;
pub const STENCIL_TEST: Capability = Capability::StencilTest;
pub const BLEND: Capability = Capability::Blend;
pub const DEPTH_CLAMP: Capability = Capability::DepthClamp;

pub const COLOR_BUFFER_BIT: Buffers = Buffers {
    color: true,
    depth: false,
    stencil: false,
};
pub const DEPTH_BUFFER_BIT: Buffers = Buffers {
    color: false,
    depth: true,
    stencil: false,
};
pub const STENCIL_BUFFER_BIT: Buffers = Buffers {
    color: false,
    depth: false,
    stencil: true,
};
/// Carr et al.'s short form.
pub const COLOR_AND_DEPTH_BUFFER_BITS: Buffers = Buffers {
    color: true,
    depth: true,
    stencil: false,
};
/// Carr et al.'s short form.
pub const DEPTH_AND_STENCIL_BUFFER_BITS: Buffers = Buffers {
    color: false,
    depth: true,
    stencil: true,
};

/// The variable of the same name is the value.
pub const fn glUniform1f(name: &'static str) -> Call {
    uniform(name, Number::Variable(name))
}

/// The program whose Local Array has as many elements as the variable says.
pub const fn glUseProgramOfSize(program: Shader, variable: &'static str) -> Call {
    useProgramOfSize(program, Number::Variable(variable))
}

/// `glStencilFunc` with the variable's value as reference.
pub const fn glStencilReference(func: Compare, variable: &'static str, mask: u32) -> Call {
    stencilReference(func, Number::Variable(variable), mask)
}

/// Everything that is not opaque, in the order of submission.
pub const fn drawTransparentObjects() -> Call {
    draw(Objects::Transparent)
}

/// Of what is not opaque, the meshes whose triangles are exactly sorted, front to back.
pub const fn drawSortedObjects() -> Call {
    draw(Objects::Sorted)
}

/// Of what is not opaque, all other meshes.
pub const fn drawUnsortedObjects() -> Call {
    draw(Objects::Unsorted)
}

/// Everything that is opaque.
pub const fn drawOpaqueObjects() -> Call {
    draw(Objects::Opaque)
}

/// The volumes' proxy geometry: the box around each.
pub const fn drawProxies() -> Call {
    draw(Objects::Proxies)
}

/// A viewport-sized quad.
pub const fn drawScreen() -> Call {
    draw(Objects::Screen)
}
