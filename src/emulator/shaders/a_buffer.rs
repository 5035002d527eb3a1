//! The twins of `glsl/a_buffer/`.

pub(super) mod begin;
pub(super) mod count;
pub(super) mod fill;
pub(super) mod fill_ordered;
mod list;
mod ray;
mod record;
pub(super) mod resolve;
mod resolve_pixel;
pub(super) mod resolve_segment;
pub(super) mod resolve_segment_or_rest;
pub(super) mod scan_gather;
pub(super) mod scan_reduce;
pub(super) mod scan_spread;
mod segment;
mod volume_ray;
