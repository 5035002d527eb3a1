//! `a_buffer/fill_ordered.frag`: the pixel's counter is a colour of the framebuffer, which a fragment reads and writes in
//! its turn.

use super::record::append;
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [counter, ..] = i.fetched(0).integers();
    Some(Kept {
        colors: vec![Texel::Integers([counter + 1, 0, 0, 1])],
        list: Some(append(i, counter)),
        ..Kept::default()
    })
}
