//! `a_buffer/segment.glsl`: which pixels a complexity segment takes (ppAO).

use crate::low_level::emulator::invocation::Inputs;

/// Those with more fragments than the segment before can take, and no more than the Local Array has elements.
pub(super) fn in_segment(i: &Inputs<'_>, count: u32) -> bool {
    let n = i.settings.size;
    let before = if n == i.define("FIRST_SEGMENT") {
        0
    } else {
        n / 2
    };
    before < count && count <= n
}
