//! The twins of what shaders include.

pub(super) mod clip;
pub(super) mod color;
pub(super) mod dual;
pub(super) mod ideal;
pub(super) mod layer;
