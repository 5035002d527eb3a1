//! `alive/first.frag`: the first layer goes under nothing, and marks its pixels by the opaque depth.

use super::super::under;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let opaque_depth = i.texel(1)[0];
    Some(Kept {
        depth: Some(opaque_depth),
        ..under::main(i)?
    })
}
