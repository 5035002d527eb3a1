//! The twins of `glsl/multi_layer/`.

pub(super) mod begin;
pub(super) mod composite;
pub(super) mod insert;
pub(super) mod node;
pub(super) mod taken;
