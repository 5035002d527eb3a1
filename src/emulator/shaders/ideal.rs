//! The twins of `glsl/ideal/`.

pub(super) mod begin;
pub(super) mod begin_as_printed;
pub(super) mod begin_tight;
pub(super) mod changed;
pub(super) mod pass_1;
pub(super) mod pass_1_as_printed;
pub(super) mod pass_2;
pub(super) mod pass_2_tight;
