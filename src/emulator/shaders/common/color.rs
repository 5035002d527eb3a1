//! Colours as blending takes them.

/// `vec4(straight.rgb * straight.a, straight.a)`
pub(in super::super) fn premultiplied([r, g, b, a]: [f32; 4]) -> [f32; 4] {
    [r * a, g * a, b * a, a]
}
