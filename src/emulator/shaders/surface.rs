//! `surface.frag`: a surface's colour, straight.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    keep(i.surface_color())
}
