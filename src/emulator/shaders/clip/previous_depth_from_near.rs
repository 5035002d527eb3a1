//! `clip/previous_depth_from_near.frag`: the same, from the lower bound on.

use super::super::common::clip::{lower_bound, upper_bound};
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let z = i.depth();
    if !(lower_bound(i) <= z && z < upper_bound(i)) {
        return None;
    }
    keep([1.0, 1.0, 1.0, z])
}
