//! `a_buffer/resolve.frag`: every pixel that has a fragment.

use super::list::list_length;
use super::resolve_pixel::resolve_pixel;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if list_length(i) == 0 {
        return None;
    }
    resolve_pixel(i)
}
