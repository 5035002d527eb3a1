//! `ideal/changed.frag`: the pixels at which pass 1 has found something.

use super::super::common::ideal::{Pixel, opaque_depth};
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [z1, ..] = Pixel::load(i).depths;
    (z1 < opaque_depth(i)).then(Kept::default)
}
