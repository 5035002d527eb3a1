//! `coplanar.frag`: a surface that unit 0 lets through, premultiplied.

use super::common::color::premultiplied;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    if !i.shadow(i.depth()) {
        return None;
    }
    keep(premultiplied(i.surface_color()))
}
