//! `clip/at_bound_as_printed.frag`: surfaces on the upper bound.

use super::super::common::clip::{clipped, upper_bound};
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    clipped(i, i.depth() == upper_bound(i))
}
