//! The twins of `glsl/alive/`.

pub(super) mod first;
pub(super) mod later;
