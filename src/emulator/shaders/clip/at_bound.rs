//! `clip/at_bound.frag`: surfaces on the upper bound, before the opaque surface.

use super::super::common::clip::opaque_depth;
use super::at_bound_as_printed;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if i.depth() >= opaque_depth(i) {
        return None;
    }
    at_bound_as_printed::main(i)
}
