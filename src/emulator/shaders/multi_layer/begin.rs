//! `multi_layer/begin.frag`: every node is empty.

use super::node::{NOTHING, texel_of};
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let empty = Texel::Integers(texel_of(NOTHING));
    Some(Kept {
        colors: vec![empty; i.define("NODES") as usize],
        ..Kept::default()
    })
}
