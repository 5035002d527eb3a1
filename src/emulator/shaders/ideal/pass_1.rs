//! `ideal/pass_1.frag`: Algorithm 2, lines 13 to 34. What lies on the opaque surface is hidden.

use super::super::common::ideal::{Pixel, opaque_depth};
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let mut pixel = Pixel::load(i);
    let z = i.depth();
    if !pixel.peel_fragment(z) && z == pixel.peel[0] && z < opaque_depth(i) {
        pixel.composite_fragment(i);
    }
    pixel.store(i)
}
