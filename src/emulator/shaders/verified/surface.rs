//! `verified/surface.frag`: a surface that nothing opaque hides.

use super::is_hidden;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if is_hidden(i) {
        return None;
    }
    keep(i.surface_color())
}
