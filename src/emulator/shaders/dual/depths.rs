//! `dual/depths.frag`: where the nearest and the farthest fragments are, by MAX.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    keep([-i.depth(), i.depth(), 0.0, 1.0])
}
