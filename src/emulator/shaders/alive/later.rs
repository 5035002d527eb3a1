//! `alive/later.frag`: a later layer, where a pixel is still alive.

use super::first;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if i.texel(3)[0] == 0.0 {
        return None;
    }
    first::main(i)
}
