//! `common/layer.glsl`: the fragment of a layer that was drawn into maps.

use crate::low_level::emulator::invocation::Inputs;

/// The layer's colour, or `None` where it lies behind the opaque surface.
pub(in super::super) fn layer(i: &Inputs<'_>) -> Option<[f32; 4]> {
    let [opaque_depth, layer_depth] = [1, 3].map(|unit| i.texel(unit)[0]);
    (layer_depth < opaque_depth).then(|| i.texel(2))
}
