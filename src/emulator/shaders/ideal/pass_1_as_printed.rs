//! `ideal/pass_1_as_printed.frag`: Algorithm 2, lines 13 to 34, as printed.

use super::super::common::ideal::Pixel;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let mut pixel = Pixel::load(i);
    let z = i.depth();
    if !pixel.peel_fragment(z) && z == pixel.peel[0] {
        pixel.composite_fragment(i);
    }
    pixel.store(i)
}
