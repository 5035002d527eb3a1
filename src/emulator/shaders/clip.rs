//! The twins of `glsl/clip/`.

pub(super) mod at_bound;
pub(super) mod at_bound_as_printed;
pub(super) mod between_peels_as_printed;
pub(super) mod closed_closed;
pub(super) mod closed_open;
pub(super) mod next_bound;
pub(super) mod open_closed;
pub(super) mod open_open;
pub(super) mod previous_depth;
pub(super) mod previous_depth_from_near;
