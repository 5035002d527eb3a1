//! `weighted/composite.frag`: the weighted mean of the colours, and what comes through all fragments as alpha.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [r, g, b, sum] = i.texel(2);
    let [r, g, b] = [r, g, b].map(|channel| if sum > 0.0 { channel / sum } else { 0.0 });
    keep([r, g, b, i.texel(3)[0]])
}
