//! `a_buffer/record.glsl` and `a_buffer/source.glsl`: a fragment's record. And `a_buffer/place.glsl`: where it goes.

use half::f16;

use crate::low_level::emulator::invocation::{Appended, Inputs};
use crate::low_level::fragment::Fragment;

/// The record, whose colour has 16 bits for each channel, or 32 with FLOAT_COLOR.
fn record(i: &Inputs<'_>) -> Fragment {
    let color = i.surface_color().map(|channel| match i.is("FLOAT_COLOR") {
        true => channel,
        false => f16::from_f32(channel).to_f32(),
    });
    Fragment {
        color: color.into(),
        ..i.fragment
    }
}

/// What becomes of a fragment that finds `count` in the pixel's counter. Fixed buffers have room for so many layers; the
/// others have room for all.
pub(super) fn append(i: &Inputs<'_>, count: u32) -> Appended {
    let is_fixed = i.define("MANAGER") == i.define("FFB");
    match is_fixed && count >= i.settings.layers {
        true => Appended::NoRoom,
        false => Appended::Stored(count, record(i)),
    }
}

/// Whether lists are linked.
pub(super) fn is_linked(i: &Inputs<'_>) -> bool {
    i.define("MANAGER") == i.define("PPLL")
}
