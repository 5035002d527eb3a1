//! `verified/behind.frag`: what lies behind the transparent surfaces goes where the list will be resolved.

use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    Some(Kept {
        images: vec![(0, Texel::Color(i.texel(3)))],
        ..Kept::default()
    })
}
