//! `over.frag`: a layer over what lies behind it.

use super::common::layer::layer;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    keep(layer(i)?)
}
