//! `a_buffer/count.frag`: the pixels of an integer image act as atomic counters.

use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [count, rest @ ..] = i.image(0).integers();
    let [g, b, a] = rest;
    Some(Kept {
        images: vec![(0, Texel::Integers([count + 1, g, b, a]))],
        ..Kept::default()
    })
}
