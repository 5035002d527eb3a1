//! `ideal/begin_as_printed.frag`: Algorithm 2, lines 7 to 12, as printed.

use super::super::common::ideal::{Pixel, opaque_depth};
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let mut pixel = Pixel::load(i);
    let far = opaque_depth(i);
    pixel.peel = [pixel.depths[2]; 4];
    pixel.depths = [far, far, pixel.depths[2], 0.0];
    pixel.store(i)
}
