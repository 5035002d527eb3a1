//! `a_buffer/list.glsl`: walking a pixel's Fragment List.

use super::record::is_linked;
use crate::low_level::emulator::invocation::Inputs;
use crate::low_level::fragment::Fragment;

/// How many fragments the pixel has.
pub(super) fn list_length(i: &Inputs<'_>) -> u32 {
    i.integers(1)[0].min(i.settings.layers)
}

/// The list as it is walked. Linked lists begin at the newest record.
pub(super) fn list(i: &Inputs<'_>) -> Vec<Fragment> {
    let length = i.records.len().min(list_length(i) as usize);
    let mut list = i.records[..length].to_vec();
    if is_linked(i) {
        list.reverse();
    }
    list
}
