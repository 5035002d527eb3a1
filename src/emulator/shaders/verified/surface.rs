//! `verified/surface.frag`: a surface that nothing opaque hides.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if i.depth() >= i.texel(5)[0] {
        return None;
    }
    keep(i.surface_color())
}
