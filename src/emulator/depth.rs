//! Depth formats: how a depth is stored, and what a lookup reads.
//!
//! A stored depth is an f32 for every format. For 32-bit float it is the depth itself. For 24 and 16 bits it is the raw
//! integer, which an f32 holds exactly.

use crate::steps::Format;

/// Raw value of the largest 24-bit depth.
const MAX_24: f32 = 16_777_215.0;
/// Raw value of the largest 16-bit depth.
const MAX_16: f32 = 65_535.0;

/// The depth that the depth test compares and writes for a fragment at `z`. It is clamped to 0..1, and rounded to the
/// nearest step of a fixed-point format. If `z` is not a number, it is 1, as on llvmpipe; GL leaves this open.
pub(super) fn stored(format: Format, z: f32) -> f32 {
    let z = if z.is_nan() { 1.0 } else { z.clamp(0.0, 1.0) };
    match format {
        // The product is rounded to f32 before it is rounded to an integer.
        Format::Depth24Stencil8 | Format::Depth24 => (z * MAX_24).round_ties_even(),
        Format::Depth16 => (z * MAX_16).round_ties_even(),
        _ => z,
    }
}

/// The value that `texelFetch` reads from a stored depth.
///
/// Fixed-point formats are read as **llvmpipe** reads them: multiplied by the nearest f32 to 1/(2^n - 1), where GL
/// divides by 2^n - 1. The quotient and the product differ in their last bit for many values, so that a depth that was
/// stored, sampled and compared may be on the wrong side of itself: `papers::carr_2008` runs on 24 bits show it.
pub(super) fn sampled_by_llvmpipe(format: Format, stored: f32) -> f32 {
    match format {
        Format::Depth24Stencil8 | Format::Depth24 => stored * (1.0 / MAX_24),
        Format::Depth16 => stored * (1.0 / MAX_16),
        _ => stored,
    }
}

/// The depth that reading a map back gives for a stored one: the quotient, as GL defines it.
pub(super) fn read_back(format: Format, stored: f32) -> f32 {
    let largest = match format {
        Format::Depth24Stencil8 => MAX_24,
        Format::Depth16 => MAX_16,
        _ => return stored,
    };
    (f64::from(stored) / f64::from(largest)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn float_depths_are_what_they_are() {
        for z in [0.0, f32::MIN_POSITIVE, 0.3, 1.0] {
            let stored = stored(Format::Depth32FStencil8, z);
            assert_eq!(sampled_by_llvmpipe(Format::Depth32FStencil8, stored), z);
        }
    }

    #[test]
    fn depths_out_of_range_are_clamped_and_not_a_number_is_the_far_plane() {
        for (z, is) in [(-1.0, 0.0), (2.0, 1.0), (f32::NAN, 1.0)] {
            assert_eq!(stored(Format::Depth32FStencil8, z), is);
        }
    }

    #[test]
    fn fixed_point_depths_round_to_the_nearest_step() {
        assert_eq!(stored(Format::Depth16, 0.5), 32768.0);
        assert_eq!(stored(Format::Depth16, 1.0), MAX_16);
        assert_eq!(stored(Format::Depth24Stencil8, 1.0), MAX_24);
        assert_eq!(stored(Format::Depth24Stencil8, 0.0), 0.0);
    }

    #[test]
    fn a_24_bit_depth_that_is_sampled_is_often_not_what_the_specification_says() {
        let off = (0..1 << 24)
            .step_by(101)
            .filter(|&raw| {
                let raw = raw as f32;
                let specified = (f64::from(raw) / f64::from(MAX_24)) as f32;
                sampled_by_llvmpipe(Format::Depth24Stencil8, raw) != specified
            })
            .count();
        // It is every second or third depth, so not a rare event.
        assert!(off > (1 << 24) / 101 / 4, "{off}");
    }
}
