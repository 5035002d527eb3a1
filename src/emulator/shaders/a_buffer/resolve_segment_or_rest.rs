//! `a_buffer/resolve_segment_or_rest.frag`: the same, but the last segment takes all that are left, too.

use super::list::list_length;
use super::resolve_pixel::resolve_pixel;
use super::segment::in_segment;
use crate::low_level::emulator::invocation::{Inputs, Outputs};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let (count, n) = (list_length(i), i.settings.size);
    let is_rest = n == i.define("LAST_SEGMENT") && count > n;
    if !in_segment(i, count) && !is_rest {
        return None;
    }
    resolve_pixel(i)
}
