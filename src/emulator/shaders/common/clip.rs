//! `common/clip.glsl` and `common/clipped.glsl`: the depth range to which a pass is clipped.

use super::color::premultiplied;
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep};

pub(in super::super) fn lower_bound(i: &Inputs<'_>) -> f32 {
    i.texel(1)[0]
}

pub(in super::super) fn upper_bound(i: &Inputs<'_>) -> f32 {
    let [upper, other_upper] = [2, 3].map(|unit| i.texel(unit)[0]);
    upper.min(other_upper).min(opaque_depth(i))
}

pub(in super::super) fn opaque_depth(i: &Inputs<'_>) -> f32 {
    i.texel(4)[0]
}

pub(in super::super) fn premultiplied_color(i: &Inputs<'_>) -> [f32; 4] {
    premultiplied(i.surface_color())
}

/// Draws a fragment that lies inside of the range.
pub(in super::super) fn clipped(i: &Inputs<'_>, is_inside: bool) -> Outputs {
    if !is_inside {
        return None;
    }
    keep(premultiplied_color(i))
}
