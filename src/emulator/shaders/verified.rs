//! The twins of `glsl/verified/`.

pub(super) mod behind;
mod hidden;
pub(super) mod mark;
pub(super) mod pieces;
pub(super) mod place;
pub(super) mod surface;

pub(super) use hidden::is_hidden;
