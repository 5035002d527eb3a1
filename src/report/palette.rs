//! Colours that mean the same in all pictures: one for each method, and a few that everybody can tell apart.

use plotters::style::{Color, HSLColor, RGBColor};

use crate::fragment::Rgba;
use crate::low_level::emulator::FragmentOutcome;

/// Okabe and Ito's colours, without black, which can be told apart in every kind of colour blindness: orange, sky blue,
/// green, yellow, blue, vermilion, purple.
pub(super) const DISTINCT: [Rgba; 7] = [
    from_bytes(0xE6, 0x9F, 0x00),
    from_bytes(0x56, 0xB4, 0xE9),
    from_bytes(0x00, 0x9E, 0x73),
    from_bytes(0xF0, 0xE4, 0x42),
    from_bytes(0x00, 0x72, 0xB2),
    from_bytes(0xD5, 0x5E, 0x00),
    from_bytes(0xCC, 0x79, 0xA7),
];
/// What is there and holds nothing.
pub(super) const UNUSED: Rgba = from_bytes(0xDD, 0xDD, 0xDD);

const fn from_bytes(r: u8, g: u8, b: u8) -> Rgba {
    Rgba::opaque([r as f32 / 255.0, g as f32 / 255.0, b as f32 / 255.0])
}

/// The colour of a fragment that ended so.
pub(super) fn of_outcome(outcome: FragmentOutcome) -> Rgba {
    match outcome {
        FragmentOutcome::Discarded => UNUSED,
        FragmentOutcome::StencilFail => DISTINCT[5],
        FragmentOutcome::DepthFail => DISTINCT[3],
        FragmentOutcome::Pass => DISTINCT[2],
    }
}

/// Three hues of four shades for A-buffers. A hue stands for a manager, and its shades for static, ppAO, ppDP, both.
pub(super) const A_BUFFERS: [(&str, RGBColor); 12] = [
    ("ffb", RGBColor(0xC6, 0xDB, 0xEF)),
    ("ffb+ppao", RGBColor(0x6B, 0xAE, 0xD6)),
    ("ffb+ppdp", RGBColor(0x21, 0x71, 0xB5)),
    ("ffb+ppao+ppdp", RGBColor(0x08, 0x30, 0x6B)),
    ("dfb", RGBColor(0xFD, 0xD0, 0xA2)),
    ("dfb+ppao", RGBColor(0xFD, 0x8D, 0x3C)),
    ("dfb+ppdp", RGBColor(0xD9, 0x48, 0x01)),
    ("dfb+ppao+ppdp", RGBColor(0x7F, 0x27, 0x04)),
    ("ppll", RGBColor(0xC7, 0xE9, 0xC0)),
    ("ppll+ppao", RGBColor(0x74, 0xC4, 0x76)),
    ("ppll+ppdp", RGBColor(0x23, 0x8B, 0x45)),
    ("ppll+ppao+ppdp", RGBColor(0x00, 0x44, 0x1B)),
];

const OTHERS: [(&str, RGBColor); 15] = [
    ("blend", RGBColor(0x00, 0x00, 0x00)),
    ("painter", RGBColor(0x80, 0x80, 0x80)),
    ("auto", RGBColor(0xE7, 0x29, 0x8A)),
    ("verified-painter", RGBColor(0x6A, 0x3D, 0x9A)),
    ("weighted-blended", RGBColor(0xB2, 0xAB, 0xD2)),
    ("multi-layer-alpha-blending", RGBColor(0xCA, 0xB2, 0xD6)),
    ("depth-peeling", RGBColor(0xCB, 0x18, 0x1D)),
    ("dual-depth-peeling", RGBColor(0xFB, 0x6A, 0x4A)),
    ("coplanar-depth-peeling", RGBColor(0xFC, 0xAE, 0x91)),
    ("layer-peeling", RGBColor(0x54, 0x30, 0x05)),
    ("hybrid-layer-peeling", RGBColor(0xC9, 0x9A, 0x2E)),
    ("coherent-layer-peeling-a", RGBColor(0x8C, 0x51, 0x0A)),
    ("coherent-layer-peeling-b", RGBColor(0xBF, 0x81, 0x2D)),
    ("ideal-coherent-layer-peeling", RGBColor(0xDF, 0xC2, 0x7D)),
    ("exact", RGBColor(0x25, 0x25, 0x25)),
];

/// For VTK's modes, whose lines are broken.
const VTK: [(&str, RGBColor); 3] = [
    ("VTK alpha", RGBColor(0x01, 0x66, 0x5E)),
    ("VTK peel", RGBColor(0x35, 0x97, 0x8F)),
    ("VTK dual", RGBColor(0x5A, 0xB4, 0xAC)),
];

/// The colour of a method, or of a mode of VTK. A method that is not in these tables has one that follows from its name.
pub(super) fn of_method(name: &str) -> RGBColor {
    let mut known = A_BUFFERS.iter().chain(&OTHERS).chain(&VTK);
    let found = known.find(|(known, _)| *known == name);
    found.map_or_else(|| of_unknown(name), |(_, color)| *color)
}

/// A hue by the name's letters (FNV-1a), dark enough for a line on white.
fn of_unknown(name: &str) -> RGBColor {
    let mix = |hash: u32, byte: u8| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    let hash = name.bytes().fold(0x811C_9DC5, mix);
    let (r, g, b) = HSLColor(f64::from(hash) / 2_f64.powi(32), 0.6, 0.4).rgb();
    RGBColor(r, g, b)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::methods::registry;

    #[test]
    fn every_method_has_a_colour_of_its_own() {
        let colors: BTreeSet<_> = registry()
            .iter()
            .map(|row| of_method(row.name))
            .map(|RGBColor(r, g, b)| (r, g, b))
            .collect();
        assert_eq!(colors.len(), registry().len());
        // So has one that nobody has given a colour.
        let [RGBColor(r, g, b), another] = ["mine", "another"].map(of_method);
        assert!(!colors.contains(&(r, g, b)) && another != RGBColor(r, g, b));
    }
}
