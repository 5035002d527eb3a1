//! `under.frag`: a layer under those before it, premultiplied.

use super::common::color::premultiplied;
use super::common::layer::layer;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(super) fn main(i: &Inputs<'_>) -> Outputs {
    keep(premultiplied(layer(i)?))
}
