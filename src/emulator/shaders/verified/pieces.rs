//! `verified/pieces.frag`: a surface, where triangles are drawn in pieces. The order that the emulated machine is told names a
//! pixel's triangle once, for the piece that its fragment is in.

use super::surface;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    surface::main(i)
}
