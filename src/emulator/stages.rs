//! The stages after the fragment shader, in GL's order, one function each (OpenGL 4.5, section 17.3).

use crate::steps::{BlendEquation, BlendFactor, StencilOp};

use super::state::{Blend, StencilTest};

/// The stencil test: whether the comparison holds between the masked reference and the masked stored value.
pub(super) fn stencil_test(test: &StencilTest, stored: u8) -> bool {
    let mask = test.mask as u8;
    // GL clamps the reference to the values that the buffer can hold.
    let reference = test.reference.clamp(0, 255) as u8;
    test.func.holds(reference & mask, stored & mask)
}

/// A stencil operation, under the write mask.
pub(super) fn stencil_op(op: StencilOp, test: &StencilTest, write_mask: u32, stored: u8) -> u8 {
    let new = match op {
        StencilOp::Keep => stored,
        StencilOp::Zero => 0,
        StencilOp::Replace => test.reference.clamp(0, 255) as u8,
        StencilOp::Incr => stored.saturating_add(1),
        StencilOp::IncrWrap => stored.wrapping_add(1),
        StencilOp::Decr => stored.saturating_sub(1),
        StencilOp::DecrWrap => stored.wrapping_sub(1),
        StencilOp::Invert => !stored,
    };
    let mask = write_mask as u8;
    (stored & !mask) | (new & mask)
}

/// Blending: `source * factor + destination * factor` in f32. Color and alpha have separate factors. Each product and
/// the sum are rounded. MIN and MAX take no factors.
pub(super) fn blend(blend: &Blend, source: [f32; 4], destination: [f32; 4]) -> [f32; 4] {
    let one_of_both = |choose: fn(f32, f32) -> f32| {
        std::array::from_fn(|channel| choose(source[channel], destination[channel]))
    };
    match blend.equation {
        BlendEquation::FuncAdd => sum(blend, source, destination),
        BlendEquation::Min => one_of_both(f32::min),
        BlendEquation::Max => one_of_both(f32::max),
    }
}

fn sum(blend: &Blend, source: [f32; 4], destination: [f32; 4]) -> [f32; 4] {
    let factor = |factor: BlendFactor| match factor {
        BlendFactor::Zero => 0.0,
        BlendFactor::One => 1.0,
        BlendFactor::SrcAlpha => source[3],
        BlendFactor::OneMinusSrcAlpha => 1.0 - source[3],
        BlendFactor::DstAlpha => destination[3],
        BlendFactor::OneMinusDstAlpha => 1.0 - destination[3],
    };
    let channel = |channel: usize, source_factor, destination_factor| {
        source[channel] * factor(source_factor) + destination[channel] * factor(destination_factor)
    };
    let color = |number| channel(number, blend.src_rgb, blend.dst_rgb);
    [
        color(0),
        color(1),
        color(2),
        channel(3, blend.src_alpha, blend.dst_alpha),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::steps::Compare;

    const TEST: StencilTest = StencilTest {
        func: Compare::Less,
        reference: 1,
        mask: 0xFF,
    };

    #[test]
    fn the_reference_stands_left_of_the_comparison() {
        // glStencilFunc(LESS, 1): passes if 1 < stored.
        assert!(!stencil_test(&TEST, 1));
        assert!(stencil_test(&TEST, 2));
    }

    #[test]
    fn incr_and_decr_saturate_and_their_wrapping_forms_wrap() {
        let op = |op, stored| stencil_op(op, &TEST, 0xFF, stored);
        assert_eq!(op(StencilOp::Incr, 255), 255);
        assert_eq!(op(StencilOp::IncrWrap, 255), 0);
        assert_eq!(op(StencilOp::Decr, 0), 0);
        assert_eq!(op(StencilOp::DecrWrap, 0), 255);
        assert_eq!(op(StencilOp::Invert, 4), 251);
        assert_eq!(op(StencilOp::Replace, 77), 1);
    }

    #[test]
    fn masked_bits_are_neither_compared_nor_written() {
        let low = StencilTest { mask: 0x0F, ..TEST };
        assert!(!stencil_test(&low, 0x11));
        assert_eq!(stencil_op(StencilOp::Invert, &TEST, 0x0F, 0x11), 0x1E);
    }

    #[test]
    fn under_keeps_what_is_in_front() {
        let under = Blend {
            equation: BlendEquation::FuncAdd,
            src_rgb: BlendFactor::OneMinusDstAlpha,
            dst_rgb: BlendFactor::One,
            src_alpha: BlendFactor::OneMinusDstAlpha,
            dst_alpha: BlendFactor::One,
        };
        let image = blend(&under, [0.5, 0.0, 0.0, 0.5], [0.0, 0.25, 0.0, 0.5]);
        assert_eq!(image, [0.25, 0.25, 0.0, 0.75]);
    }

    #[test]
    fn min_and_max_take_channels_one_by_one_and_no_factors() {
        let by = |equation| {
            let blend = Blend {
                equation,
                src_rgb: BlendFactor::Zero,
                dst_rgb: BlendFactor::Zero,
                src_alpha: BlendFactor::Zero,
                dst_alpha: BlendFactor::Zero,
            };
            super::blend(&blend, [0.5, -2.0, 0.0, 1.0], [0.25, 0.0, 0.0, 2.0])
        };
        assert_eq!(by(BlendEquation::Min), [0.25, -2.0, 0.0, 1.0]);
        assert_eq!(by(BlendEquation::Max), [0.5, 0.0, 0.0, 2.0]);
    }
}
