//! `peel.frag`: a surface behind the layers that were peeled.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    if !i.shadow(i.depth()) {
        return None;
    }
    keep(i.surface_color())
}
