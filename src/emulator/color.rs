//! Color maps: what a texel is, and how each format stores it.

use half::f16;

use crate::steps::Format;

pub use crate::steps::Texel;

/// Whether a format has whole numbers.
pub(super) fn has_integers(format: Format) -> bool {
    matches!(format, Format::R32Ui | Format::Rgba32Ui)
}

/// What a map of this format stores of a colour.
pub(super) fn stored(format: Format, color: [f32; 4]) -> [f32; 4] {
    let steps = |steps: f32| {
        move |channel: f32| (channel.clamp(0.0, 1.0) * steps).round_ties_even() / steps
    };
    match format {
        Format::Rgba8 => color.map(steps(255.0)),
        Format::Rgb10A2 => {
            let [r, g, b, a] = color;
            let [r, g, b] = [r, g, b].map(steps(1023.0));
            [r, g, b, steps(3.0)(a)]
        }
        Format::Rgba16F => color.map(|channel| f16::from_f32(channel).to_f32()),
        Format::Rg16 => with_two(color.map(steps(65_535.0))),
        Format::Rg32F => with_two(color),
        Format::R32F => [color[0], 0.0, 0.0, 1.0],
        _ => color,
    }
}

/// The same of whole numbers.
pub(super) fn stored_integers(format: Format, integers: [u32; 4]) -> [u32; 4] {
    match format {
        Format::R32Ui => [integers[0], 0, 0, 1],
        _ => integers,
    }
}

fn with_two([r, g, _, _]: [f32; 4]) -> [f32; 4] {
    [r, g, 0.0, 1.0]
}

/// The shader's output as blending sees it: a fixed-point target clamps it first.
pub(super) fn blended(format: Format, color: [f32; 4]) -> [f32; 4] {
    match format {
        Format::Rgba8 | Format::Rgb10A2 | Format::Rg16 => {
            color.map(|channel| channel.clamp(0.0, 1.0))
        }
        _ => color,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn red(format: Format, red: f32) -> f32 {
        stored(format, [red; 4])[0]
    }

    #[test]
    fn eight_bits_round_to_the_nearest_of_256() {
        assert_eq!(red(Format::Rgba8, 0.5), 128.0 / 255.0);
        assert_eq!(red(Format::Rgba8, 1.7), 1.0);
        assert_eq!(red(Format::Rgba8, -0.1), 0.0);
    }

    #[test]
    fn sixteen_bit_floats_have_eleven_bits() {
        assert_eq!(red(Format::Rgba16F, 1.0 + 1.0 / 1024.0), 1.0 + 1.0 / 1024.0);
        assert_eq!(red(Format::Rgba16F, 1.0 + 1.0 / 4096.0), 1.0);
    }

    #[test]
    fn thirty_two_bits_are_kept() {
        assert_eq!(red(Format::Rgba32F, 0.1), 0.1);
        assert_eq!(red(Format::R32F, -1.0), -1.0);
    }

    #[test]
    fn channels_that_a_format_lacks_are_looked_up_as_0_and_alpha_as_1() {
        let color = [0.25, 0.5, 0.75, 0.125];
        assert_eq!(stored(Format::R32F, color), [0.25, 0.0, 0.0, 1.0]);
        assert_eq!(stored(Format::Rg32F, color), [0.25, 0.5, 0.0, 1.0]);
    }

    #[test]
    fn two_bits_of_alpha_have_four_values() {
        let alpha = |alpha| stored(Format::Rgb10A2, [alpha; 4])[3];
        assert_eq!(
            [0.1, 0.3, 0.6, 0.9].map(alpha),
            [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]
        );
    }
}
