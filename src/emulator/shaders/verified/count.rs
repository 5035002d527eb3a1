//! `verified/count.frag`: the fragments of the pixels that have a list. The emulated machine needs no room for lists, so
//! nobody asks how many there are.

use super::is_hidden;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    (!is_hidden(i)).then(Kept::default)
}
