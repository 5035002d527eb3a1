//! `a_buffer/record.glsl` and `a_buffer/source.glsl`: a fragment's record. And `a_buffer/place.glsl`: where it goes.

use half::f16;

use crate::low_level::emulator::invocation::{Appended, Inputs};
use crate::low_level::fragment::Fragment;

/// 24 bits.
const LARGEST: f32 = 16_777_215.0;

/// The record. Its colour has 16 bits for each channel, 32 with FLOAT_COLOR, or 24 with FIXED_COLOR. Then its id is in no
/// buffer, and known here all the same.
fn record(i: &Inputs<'_>) -> Fragment {
    let stored = |channel: f32| {
        if i.is("FLOAT_COLOR") {
            channel
        } else if i.is("FIXED_COLOR") {
            (channel.clamp(0.0, 1.0) * LARGEST).round_ties_even() / LARGEST
        } else {
            f16::from_f32(channel).to_f32()
        }
    };
    Fragment {
        color: i.surface_color().map(stored).into(),
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
