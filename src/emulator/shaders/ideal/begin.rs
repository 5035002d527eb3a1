//! `ideal/begin.frag`: Algorithm 2, lines 7 to 12: z3 goes to the opaque depth, so that a pixel with nothing left ends there.

use super::super::common::ideal::{Pixel, opaque_depth};
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let mut pixel = Pixel::load(i);
    let far = opaque_depth(i);
    pixel.peel = [pixel.depths[2]; 4];
    pixel.depths = [far, far, far, 0.0];
    pixel.store(i)
}
