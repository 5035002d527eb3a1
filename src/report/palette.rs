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
    ("ffb", RGBColor(0xA6, 0xCE, 0xE3)),
    ("ffb+ppao", RGBColor(0x6B, 0xAE, 0xD6)),
    ("ffb+ppdp", RGBColor(0x21, 0x71, 0xB5)),
    ("ffb+ppao+ppdp", RGBColor(0x08, 0x30, 0x6B)),
    ("dfb", RGBColor(0xFD, 0xBE, 0x85)),
    ("dfb+ppao", RGBColor(0xFD, 0x8D, 0x3C)),
    ("dfb+ppdp", RGBColor(0xD9, 0x48, 0x01)),
    ("dfb+ppao+ppdp", RGBColor(0x7F, 0x27, 0x04)),
    ("ppll", RGBColor(0x85, 0xD6, 0xA0)),
    ("ppll+ppao", RGBColor(0x4D, 0xBE, 0x97)),
    ("ppll+ppdp", RGBColor(0x00, 0x88, 0x5F)),
    ("ppll+ppao+ppdp", RGBColor(0x00, 0x3A, 0x26)),
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
    ("layer-peeling", RGBColor(0x00, 0x3C, 0x30)),
    ("hybrid-layer-peeling", RGBColor(0x35, 0x97, 0x8F)),
    ("coherent-layer-peeling-a", RGBColor(0x8C, 0x51, 0x0A)),
    ("coherent-layer-peeling-b", RGBColor(0xBF, 0x81, 0x2D)),
    ("ideal-coherent-layer-peeling", RGBColor(0xDF, 0xC2, 0x7D)),
    ("exact", RGBColor(0x25, 0x25, 0x25)),
];

/// For VTK's modes, whose lines are broken.
const VTK: [(&str, RGBColor); 3] = [
    ("VTK alpha", RGBColor(0x40, 0x40, 0x40)),
    ("VTK peel", RGBColor(0x70, 0x70, 0x70)),
    ("VTK dual", RGBColor(0xA0, 0xA0, 0xA0)),
];

/// The colour of a method, or of a mode of VTK. A method that is not in these tables has one that follows from its name.
pub(super) fn of_method(name: &str) -> RGBColor {
    let mut known = A_BUFFERS.iter().chain(&OTHERS).chain(&VTK);
    let found = known.find(|(known, _)| *known == name);
    found.map_or_else(|| of_unknown(name), |(_, color)| *color)
}

/// The colour of the method that a text names in words, as in "iterations of layer peeling". Of two names the longer one
/// counts. `None` if it names no method.
pub(super) fn of_text(text: &str) -> Option<RGBColor> {
    let words = text.to_lowercase().replace(' ', "-");
    let known = A_BUFFERS.iter().chain(&OTHERS);
    let named = known.filter(|(name, _)| name.contains('-') && words.contains(name));
    named
        .max_by_key(|(name, _)| name.len())
        .map(|(_, color)| *color)
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

    #[test]
    fn a_text_that_names_a_method_has_its_colour() {
        let hybrid = of_method("hybrid-layer-peeling");
        assert_eq!(of_text("iterations of hybrid layer peeling"), Some(hybrid));
        let coherent = of_method("coherent-layer-peeling-a");
        assert_eq!(of_text("coherent layer peeling A, ms"), Some(coherent));
        assert_eq!(of_text("rms difference"), None);
    }

    /// Matrices for linear light of Machado, Oliveira and Fernandes (2009) for complete protanopia, deuteranopia and
    /// tritanopia.
    const BLINDNESSES: [[[f64; 3]; 3]; 3] = [
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
        [
            [1.255_528, -0.076_749, -0.178_779],
            [-0.078_411, 0.930_809, 0.147_602],
            [0.004_733, 0.691_367, 0.303_900],
        ],
    ];

    fn times(matrix: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// A colour of a screen (sRGB) as somebody sees it, in CIELAB for the white of the screen.
    fn seen(bytes: [u8; 3], blindness: &[[f64; 3]; 3]) -> [f64; 3] {
        let linear = bytes.map(|byte| {
            let c = f64::from(byte) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                ((c + 0.055) / 1.055).powf(2.4)
            }
        });
        let rgb = times(blindness, linear).map(|c| c.clamp(0.0, 1.0));
        let to_xyz = [
            [0.4124, 0.3576, 0.1805],
            [0.2126, 0.7152, 0.0722],
            [0.0193, 0.1192, 0.9505],
        ];
        let [x, y, z] = times(&to_xyz, rgb);
        let f = |t: f64| {
            if t > 0.008_856 {
                t.cbrt()
            } else {
                7.787 * t + 16.0 / 116.0
            }
        };
        let [x, y, z] = [f(x / 0.9505), f(y), f(z / 1.089)];
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// The distance of the two colours that are nearest to each other, for those who see worst.
    fn nearest(colors: &[[u8; 3]]) -> f64 {
        let mut least = f64::INFINITY;
        for blindness in &BLINDNESSES {
            for (n, &a) in colors.iter().enumerate() {
                for &b in &colors[..n] {
                    let (a, b) = (seen(a, blindness), seen(b, blindness));
                    let squares = [0, 1, 2].map(|axis| (a[axis] - b[axis]).powi(2));
                    least = least.min(squares.iter().sum::<f64>().sqrt());
                }
            }
        }
        least
    }

    /// A distance of 2.3 in CIELAB can just be noticed side by side. Small areas apart from each other need several times
    /// as much; 10 is common for the parts of a map.
    const ENOUGH: f64 = 10.0;

    #[test]
    fn the_colour_blind_can_tell_apart_what_is_to_be_told_apart() {
        let bytes = |color: Rgba| [color.r, color.g, color.b].map(|c| (c * 255.0).round() as u8);
        let distinct: Vec<_> = DISTINCT.into_iter().chain([UNUSED]).map(bytes).collect();
        println!("colours that tell apart: {:.1}", nearest(&distinct));
        assert!(nearest(&distinct) > ENOUGH);
        // The three managers, in each of the four shades.
        for shade in 0..4 {
            let hues = [0, 4, 8].map(|manager| {
                let RGBColor(r, g, b) = A_BUFFERS[manager + shade].1;
                [r, g, b]
            });
            println!("managers, shade {shade}: {:.1}", nearest(&hues));
            assert!(nearest(&hues) > ENOUGH, "{hues:?}");
        }
        // Red and green of one lightness are what nobody should choose.
        assert!(nearest(&[[200, 90, 40], [120, 120, 30]]) < ENOUGH);
    }
}
