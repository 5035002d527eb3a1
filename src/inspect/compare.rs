//! Comparing what OpenGL holds at a pixel with what the emulated pixel holds.

use crate::gl::Quirks;
use crate::steps::{Format, Held, Texel};

/// By how much values may differ, which depends on the formats and on the driver.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    color: f32,
    /// The same for programs that weight colors by the distance from the eye.
    weighted: f32,
}

impl Bounds {
    /// For maps that hold their colors in this format.
    ///
    /// OpenGL leaves the rounding of a blend open. llvmpipe's is the emulated pixel's, to the bit, in 32-bit float. A GPU may
    /// round a product and a sum together: each of up to 64 blends then is off by half a step of 2^-24, of colours up to 1.
    /// Where every blend is rounded to 8 bits or to 11, each may go another way at a tie.
    ///
    /// The emulated pixel computes distances from depths. A depth is off by 2^-24, its distance by as many times that as the
    /// far plane is farther than the near one, and OpenGL's own distance by 2^-24. A weight (McGuire and Bavoil 2013,
    /// equations 7 to 10) has up to the sixth power of it, and some 20 roundings more; up to 64 of them are added up.
    pub(super) fn of(format: Format, quirks: Quirks, [near, far]: [f64; 2]) -> Self {
        let weight = 6.0 * (far / near + 1.0) + 20.0 + 64.0;
        let color = match format {
            Format::Rgba8 => 20.0 / 255.0,
            Format::Rgba16F => 20.0 / 2048.0,
            _ if quirks.blends_in_three_roundings => 0.0,
            _ => 64.0 * 2.0_f32.powi(-24),
        };
        Self {
            color,
            weighted: color + weight as f32 * 2.0_f32.powi(-24),
        }
    }

    /// The same, but colors may differ by so much more.
    pub(super) fn and(self, more: f32) -> Self {
        Self {
            color: self.color + more,
            weighted: self.weighted + more,
        }
    }

    /// How the two differ, in words. Depths and stencil values must be the same to the bit.
    pub(super) fn differences(&self, program: &str, emulated: &Held, gl: &Held) -> Vec<String> {
        let bound = match program.starts_with("weighted/") {
            true => self.weighted,
            false => self.color,
        };
        let mut differences = Vec::new();
        let mut differ = |what: &str, gl: String, emulated: String| {
            differences.push(format!(
                "{what}: OpenGL has {gl}, the emulated pixel {emulated}"
            ));
        };
        if emulated.depth != gl.depth {
            let text = |held: &Held| held.depth.map_or("none".into(), |depth| depth.to_string());
            differ("depth", text(gl), text(emulated));
        }
        if emulated.stencil != gl.stencil {
            let text = |held: &Held| held.stencil.map_or("none".into(), |it| it.to_string());
            differ("stencil", text(gl), text(emulated));
        }
        let colors = emulated.colors.len().max(gl.colors.len());
        for number in 0..colors {
            let [ours, theirs] = [emulated, gl].map(|held| held.colors.get(number));
            let same = ours.zip(theirs).is_some_and(|(a, b)| same(a, b, bound));
            if !same {
                let text = |texel: Option<&Texel>| texel.map_or("none".into(), texel_text);
                differ(&format!("color {number}"), text(theirs), text(ours));
            }
        }
        differences
    }
}

/// Whether two texels differ by no more than the bound, which is relative to values over 1.
fn same(a: &Texel, b: &Texel, bound: f32) -> bool {
    match (a, b) {
        (Texel::Integers(a), Texel::Integers(b)) => a == b,
        (Texel::Color(a), Texel::Color(b)) => a.iter().zip(b).all(|(a, b)| {
            // Bits first, so that infinities and what is not a number are the same as themselves. A driver may take what is
            // smaller than the smallest normal number for 0.
            let bound = (bound * b.abs().max(1.0)).max(f32::MIN_POSITIVE);
            a.to_bits() == b.to_bits() || (a - b).abs() <= bound
        }),
        _ => false,
    }
}

fn texel_text(texel: &Texel) -> String {
    match texel {
        Texel::Color(channels) => format!("{channels:?}"),
        Texel::Integers(channels) => format!("{channels:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXACT: Bounds = Bounds {
        color: 0.0,
        weighted: 0.0,
    };

    fn held() -> Held {
        Held {
            depth: Some(0.25),
            stencil: Some(3),
            colors: vec![Texel::Color([0.5; 4]), Texel::Integers([7; 4])],
        }
    }

    #[test]
    fn the_same_values_do_not_differ() {
        assert!(EXACT.differences("peel", &held(), &held()).is_empty());
    }

    #[test]
    fn each_value_that_is_off_is_said() {
        let changed = |change: fn(&mut Held)| {
            let mut other = held();
            change(&mut other);
            EXACT.differences("peel", &held(), &other).join("; ")
        };
        let depth = changed(|held| held.depth = Some(0.25_f32.next_up()));
        assert_eq!(
            depth,
            "depth: OpenGL has 0.25000003, the emulated pixel 0.25"
        );
        assert!(changed(|held| held.stencil = None).starts_with("stencil: OpenGL has none"));
        let color = changed(|held| held.colors[0] = Texel::Color([0.5, 0.5, 0.5, 0.75]));
        assert!(color.starts_with("color 0"), "{color}");
        assert!(changed(|held| held.colors.truncate(1)).starts_with("color 1"));
    }

    #[test]
    fn colors_may_be_off_by_the_bound_and_no_more() {
        let bounds = Bounds {
            color: 0.01,
            weighted: 0.1,
        };
        let of = |program, off: f32| {
            let mut other = held();
            other.colors[0] = Texel::Color([0.5 + off; 4]);
            bounds.differences(program, &held(), &other).len()
        };
        let peel = |off| of("peel", off);
        assert_eq!([peel(0.005), peel(0.02), peel(f32::NAN)], [0, 1, 1]);
        let weighted = |off| of("weighted/accumulate", off);
        assert_eq!([weighted(0.02), weighted(0.2)], [0, 1]);
    }
}
