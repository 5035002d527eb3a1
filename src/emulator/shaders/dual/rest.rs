//! `dual/rest.frag`: the fragments that are left to peel.

use super::super::common::dual::nearest_and_farthest;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [nearest, farthest] = nearest_and_farthest(i);
    if i.depth() < nearest || i.depth() > farthest {
        return None;
    }
    keep([1.0; 4])
}
