//! `multi_layer/composite.frag`: the nodes front to back, and what comes through all of them as alpha.

use super::node::{NOTHING, merged, node_of};
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let nodes = (0..i.define("NODES")).map(|unit| node_of(i.integers(unit)));
    let all = nodes.fold(NOTHING, merged);
    let [r, g, b] = all.color;
    keep([r, g, b, all.transmittance])
}
