//! OpenGL's calls and constants under OpenGL's names, so that a listing reads like the paper's.
//!
//! Each function only makes the [`Step`] that says the call; nothing here calls GL. Constants stand without their
//! `GL_`, as Carr et al. print them.

#![allow(non_snake_case, non_upper_case_globals, missing_docs)] // GL's own names; the GL specification is their manual

use super::call::*;
use super::draw_buffer::{BlendEquation, DrawBufferCall};
use super::listing::Step;

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

pub const fn glClearColor(red: f32, green: f32, blue: f32, alpha: f32) -> Step {
    Step::Call(Call::ClearColor {
        red,
        green,
        blue,
        alpha,
    })
}

pub const fn glClearDepth(depth: f64) -> Step {
    Step::Call(Call::ClearDepth { depth })
}

pub const fn glClearStencil(s: i32) -> Step {
    Step::Call(Call::ClearStencil { s })
}

pub const fn glClear(mask: Buffers) -> Step {
    Step::Call(Call::Clear { mask })
}

pub const fn glEnable(cap: Capability) -> Step {
    Step::Call(Call::Enable { cap })
}

pub const fn glDisable(cap: Capability) -> Step {
    Step::Call(Call::Disable { cap })
}

pub const fn glDepthFunc(func: Compare) -> Step {
    Step::Call(Call::DepthFunc { func })
}

pub const fn glDepthMask(flag: bool) -> Step {
    Step::Call(Call::DepthMask { flag })
}

pub const fn glColorMask(red: bool, green: bool, blue: bool, alpha: bool) -> Step {
    Step::Call(Call::ColorMask {
        red,
        green,
        blue,
        alpha,
    })
}

pub const fn glColorMaski(buf: u32, red: bool, green: bool, blue: bool, alpha: bool) -> Step {
    Step::Call(Call::ColorMaski {
        buf,
        red,
        green,
        blue,
        alpha,
    })
}

pub const fn glStencilMask(mask: u32) -> Step {
    Step::Call(Call::StencilMask { mask })
}

pub const fn glStencilFunc(func: Compare, reference: i32, mask: u32) -> Step {
    Step::Call(Call::StencilFunc {
        func,
        reference,
        mask,
    })
}

pub const fn glStencilOp(sfail: StencilOp, dpfail: StencilOp, dppass: StencilOp) -> Step {
    Step::Call(Call::StencilOp {
        sfail,
        dpfail,
        dppass,
    })
}

pub const fn glBlendFunc(sfactor: BlendFactor, dfactor: BlendFactor) -> Step {
    Step::Call(Call::BlendFunc { sfactor, dfactor })
}

pub const fn glBlendFuncSeparate(
    src_rgb: BlendFactor,
    dst_rgb: BlendFactor,
    src_alpha: BlendFactor,
    dst_alpha: BlendFactor,
) -> Step {
    Step::Call(Call::BlendFuncSeparate {
        src_rgb,
        dst_rgb,
        src_alpha,
        dst_alpha,
    })
}

pub const fn glBlendEquationi(buf: u32, mode: BlendEquation) -> Step {
    Step::Call(Call::DrawBuffer(DrawBufferCall::BlendEquation {
        buf,
        mode,
    }))
}

pub const fn glBlendFunci(buf: u32, src: BlendFactor, dst: BlendFactor) -> Step {
    Step::Call(Call::DrawBuffer(DrawBufferCall::BlendFunc {
        buf,
        src,
        dst,
    }))
}

/// `glClearBufferfv(COLOR, ...)`, the four channels one by one.
pub const fn glClearBufferfv(drawbuffer: u32, value: [f32; 4]) -> Step {
    Step::Call(Call::DrawBuffer(DrawBufferCall::Clear {
        drawbuffer,
        value,
    }))
}

pub const fn glActiveTexture(unit: u32) -> Step {
    Step::Call(Call::ActiveTexture { unit })
}

pub const fn glBindTexture(texture: Map) -> Step {
    Step::Call(Call::BindTexture { texture })
}

pub const fn glSamplerCompareFunc(func: Compare) -> Step {
    Step::Call(Call::SamplerCompareFunc { func })
}

/// The variable of the same name is the value.
pub const fn glUniform1f(name: &'static str) -> Step {
    Step::Call(Call::Uniform { name, value: None })
}

pub const fn glUseProgram(program: Shader) -> Step {
    Step::Call(Call::UseProgram { program })
}

/// The program whose Local Array has as many elements as the variable says.
pub const fn glUseProgramOfSize(program: Shader, variable: &'static str) -> Step {
    Step::Call(Call::UseProgramOfSize {
        program,
        size: Index::Variable(variable),
    })
}

/// `glStencilFunc` with the variable's value as reference.
pub const fn glStencilReference(func: Compare, variable: &'static str, mask: u32) -> Step {
    Step::Call(Call::StencilReference {
        func,
        reference: Index::Variable(variable),
        mask,
    })
}

/// Zeros in an integer colour buffer.
pub const fn glClearBufferuiv(drawbuffer: u32) -> Step {
    Step::Call(Call::ClearIntegers { drawbuffer })
}

pub const fn glBindImageTexture(unit: u32, texture: Map) -> Step {
    Step::Call(Call::BindImage { unit, texture })
}

pub const fn glBindStorageBuffer(index: u32, buffer: Storage) -> Step {
    Step::Call(Call::BindStorage { index, buffer })
}

pub const fn glMemoryBarrier() -> Step {
    Step::Call(Call::MemoryBarrier)
}

pub const fn glBindFramebuffer(framebuffer: Target) -> Step {
    Step::Call(Call::BindFramebuffer { framebuffer })
}

pub const fn glFramebufferColor(texture: Map) -> Step {
    Step::Call(Call::AttachColor { texture })
}

pub const fn glFramebufferDepth(texture: Map) -> Step {
    Step::Call(Call::AttachDepth { texture })
}

pub const fn glBeginQuery(query: Query) -> Step {
    Step::Call(Call::BeginQuery { query })
}

pub const fn glEndQuery(query: Query) -> Step {
    Step::Call(Call::EndQuery { query })
}

pub const fn glCopyImageSubData(from: Map, to: Map) -> Step {
    Step::Call(Call::CopyImage { from, to })
}

/// Listing 1's 'bind buffer', for a buffer that is not one of a row.
pub const fn bindDepthBuffer(buffer: Map) -> Step {
    Step::Call(Call::BindDepthBuffer { buffer })
}

/// Exchanges two maps' names.
pub const fn swap(a: Map, b: Map) -> Step {
    Step::Call(Call::Swap { a, b })
}

/// Everything that is not opaque, in the order of submission.
pub const fn drawTransparentObjects() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Transparent,
    })
}

/// Of what is not opaque, the meshes whose triangles are exactly sorted, front to back.
pub const fn drawSortedObjects() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Sorted,
    })
}

/// Of what is not opaque, all other meshes.
pub const fn drawUnsortedObjects() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Unsorted,
    })
}

/// Everything that is opaque.
pub const fn drawOpaqueObjects() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Opaque,
    })
}

/// The volumes' proxy geometry: the box around each.
pub const fn drawProxies() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Proxies,
    })
}

/// A viewport-sized quad.
pub const fn drawScreen() -> Step {
    Step::Call(Call::Draw {
        objects: Objects::Screen,
    })
}
