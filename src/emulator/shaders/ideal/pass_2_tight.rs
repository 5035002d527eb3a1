//! `ideal/pass_2_tight.frag`: Algorithm 2, lines 36 to 40: an unbroken run ends at z2.

use super::super::common::ideal::Pixel;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let mut pixel = Pixel::load(i);
    let z = i.depth();
    if pixel.peel[0] < z && z < pixel.tight_bound() {
        pixel.composite_fragment(i);
    }
    pixel.store(i)
}
