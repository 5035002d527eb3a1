//! `verified/place.frag`: what the list of a marked pixel was resolved to.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    keep(i.texel(3))
}
