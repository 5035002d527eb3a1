//! OpenGL's calls and constants under OpenGL's names, so that a listing reads like the paper's.
//!
//! Each function only makes a [`Call`]; nothing here calls GL. Most functions come from the table of calls. Constants
//! have no `GL_` prefix, as Carr et al. print them.

#![allow(non_snake_case, missing_docs)] // GL's own names; the GL specification is their manual

use super::call::Call;
use super::constants::*;
use super::names::{Number, Shader};

pub use super::call::functions::*;
pub use super::constants::named::*;
pub use super::gl_classic::*;

/// Carr et al.'s name for `GL_DST_ALPHA`.
pub const DEST_ALPHA: BlendFactor = BlendFactor::DstAlpha;

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
/// All three.
pub const ALL_BUFFER_BITS: Buffers = Buffers {
    color: true,
    depth: true,
    stencil: true,
};

/// The value is that of the variable with the same name.
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

/// Draws all objects that are not opaque, in the order of submission.
pub const fn drawTransparentObjects() -> Call {
    draw(Objects::Transparent)
}

/// Draws the objects that are not opaque and whose triangles are sorted exactly, front to back.
pub const fn drawSortedObjects() -> Call {
    draw(Objects::Sorted)
}

/// Draws the other objects that are not opaque.
pub const fn drawUnsortedObjects() -> Call {
    draw(Objects::Unsorted)
}

/// Draws all opaque objects.
pub const fn drawOpaqueObjects() -> Call {
    draw(Objects::Opaque)
}

/// Draws the volumes' proxy geometry: the box around each volume.
pub const fn drawProxies() -> Call {
    draw(Objects::Proxies)
}

/// Draws a quad of the viewport's size.
pub const fn drawScreen() -> Call {
    draw(Objects::Screen)
}
