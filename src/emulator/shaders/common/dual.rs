//! `common/dual.glsl`: the depths between which fragments are left.

use crate::low_level::emulator::invocation::Inputs;

/// No fragment is nearer than 0, and none is farther than 1.
pub(in super::super) const NOTHING: [f32; 4] = [-2.0, -2.0, 0.0, 1.0];

/// The nearest and the farthest depth. If no fragment is left, the nearest is the larger one.
pub(in super::super) fn nearest_and_farthest(i: &Inputs<'_>) -> [f32; 2] {
    let [nearest, farthest, ..] = i.texel(2);
    [-nearest, farthest]
}
