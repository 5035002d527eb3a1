//! `clip/closed_open.frag`: surfaces from the lower bound on, before the upper one.

use super::super::common::clip::{clipped, lower_bound, upper_bound};
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let z = i.depth();
    clipped(i, lower_bound(i) <= z && z < upper_bound(i))
}
