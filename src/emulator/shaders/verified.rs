//! The twins of `glsl/verified/`.

pub(super) mod surface;
