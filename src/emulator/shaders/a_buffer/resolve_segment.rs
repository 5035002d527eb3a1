//! `a_buffer/resolve_segment.frag`: the pixels of a complexity segment, by their own counts.

use super::list::list_length;
use super::resolve_pixel::resolve_pixel;
use super::segment::in_segment;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    if !in_segment(i, list_length(i)) {
        return None;
    }
    resolve_pixel(i)
}
