//! The twins of `glsl/dual/`.

pub(super) mod depths;
pub(super) mod left;
pub(super) mod peel;
pub(super) mod rest;
