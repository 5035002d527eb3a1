//! `verified/hidden.glsl`: what opaque surfaces hide, where the depth test is busy with something else.

use crate::low_level::emulator::invocation::Inputs;

/// Whether it is hidden. Scenes without opaque surfaces look nothing up.
pub(in super::super) fn is_hidden(i: &Inputs<'_>) -> bool {
    let has_opaque = i.settings.defines.get("OPAQUE") != Some(&0);
    has_opaque && i.depth() >= i.texel(5)[0]
}
