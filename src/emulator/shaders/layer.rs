//! `layer.frag`: a map's colour as it is.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    keep(i.texel(2))
}
