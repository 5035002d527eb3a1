//! Color formats: how a colour is stored.

use half::f16;

use crate::steps::Format;

/// The value of a channel that a map of this format stores.
pub(super) fn stored(format: Format, channel: f32) -> f32 {
    match format {
        Format::Rgba8 => (channel.clamp(0.0, 1.0) * 255.0).round_ties_even() / 255.0,
        Format::Rgba16F => f16::from_f32(channel).to_f32(),
        _ => channel,
    }
}

/// The shader's output as blending sees it: a fixed-point target clamps it first.
pub(super) fn blended(format: Format, channel: f32) -> f32 {
    match format {
        Format::Rgba8 => channel.clamp(0.0, 1.0),
        _ => channel,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_bits_round_to_the_nearest_of_256() {
        assert_eq!(stored(Format::Rgba8, 0.5), 128.0 / 255.0);
        assert_eq!(stored(Format::Rgba8, 1.7), 1.0);
        assert_eq!(stored(Format::Rgba8, -0.1), 0.0);
    }

    #[test]
    fn sixteen_bit_floats_have_eleven_bits() {
        assert_eq!(
            stored(Format::Rgba16F, 1.0 + 1.0 / 1024.0),
            1.0 + 1.0 / 1024.0
        );
        assert_eq!(stored(Format::Rgba16F, 1.0 + 1.0 / 4096.0), 1.0);
    }

    #[test]
    fn thirty_two_bits_are_kept() {
        assert_eq!(stored(Format::Rgba32F, 0.1), 0.1);
        assert_eq!(stored(Format::R32F, -1.0), -1.0);
    }
}
