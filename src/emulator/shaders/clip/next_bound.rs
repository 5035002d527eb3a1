//! `clip/next_bound.frag`: the nearest of the ends as the depth.

use super::super::common::clip::upper_bound;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    Some(Kept {
        depth: Some(upper_bound(i)),
        ..Kept::default()
    })
}
