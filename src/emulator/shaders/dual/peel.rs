//! `dual/peel.frag`: the nearest fragments go to the front, the farthest to the back, and the others say where the next
//! peel is.

use super::super::common::color::premultiplied;
use super::super::common::dual::{NOTHING, nearest_and_farthest};
use crate::low_level::emulator::invocation::{Inputs, Outputs, keep_all};

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [nearest, farthest] = nearest_and_farthest(i);
    let z = i.depth();
    if z < nearest || z > farthest {
        return None;
    }
    let at_nearest = z == nearest;
    let at_farthest = z == farthest;
    let color = premultiplied(i.surface_color());
    let next = match at_nearest || at_farthest {
        true => NOTHING,
        false => [-z, z, 0.0, 1.0],
    };
    let front = if at_nearest { color } else { [0.0; 4] };
    let back = match at_farthest && !at_nearest {
        true => color,
        false => [0.0; 4],
    };
    keep_all([next, front, back])
}
