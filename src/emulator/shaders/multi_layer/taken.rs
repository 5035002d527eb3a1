//! `multi_layer/taken.frag`: the pixels in which a node is filled.

use super::node::NO_DEPTH;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    (i.integers(0)[0] != NO_DEPTH).then(Kept::default)
}
