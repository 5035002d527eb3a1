//! The twins of `glsl/weighted/`.

pub(super) mod accumulate;
pub(super) mod composite;
