//! Mistakes that change the colour of each pixel separately.

use super::super::file::srgb;
use super::pair::{Pair, Tried};
use crate::fragment::Rgba;

pub(super) fn tried(pair: &Pair<'_>) -> Vec<Tried> {
    let mut tried = vec![
        alpha_alone(pair),
        Tried::new(
            pair.left(|p| colors(p, srgb)),
            "The image is the exact one, encoded as sRGB. Write linear values, or decode it before you check it.",
        ),
        Tried::new(
            pair.left(|p| colors(p, linear)),
            "The image is the exact one after a decoding from sRGB that it did not need: the exact one is the sRGB \
             encoding of the image.",
        ),
        Tried::new(
            pair.left(|p| colors(p, |v| v.max(0.0).powf(1.0 / 2.2))),
            "The image is the exact one, encoded with a gamma of 2.2. Write linear values.",
        ),
        Tried::new(
            pair.left(|p| colors(p, |v| v.max(0.0).powf(2.2))),
            "The image is the exact one, decoded with a gamma of 2.2 that it did not need.",
        ),
        Tried::new(
            pair.left(|p| colors(p, |v| 1.0 - v)),
            "The image is the negative of the exact one.",
        ),
        Tried::new(
            pair.left(|p| Rgba::new(p.r * p.a, p.g * p.a, p.b * p.a, p.a)),
            "The image's colours are the exact ones multiplied by their alpha: it is premultiplied, the exact one is \
             straight.",
        ),
        Tried::new(
            unmultiplied(pair),
            "The exact image's colours are the image's multiplied by alpha: the image is straight, the exact one is \
             premultiplied.",
        ),
    ];
    tried.extend(swapped(pair));
    tried.extend(scaled(pair));
    tried
}

/// Applies a function to red, green and blue.
fn colors(pixel: &Rgba, rule: impl Fn(f32) -> f32) -> Rgba {
    Rgba::new(rule(pixel.r), rule(pixel.g), rule(pixel.b), pixel.a)
}

/// The inverse of sRGB's encoding.
fn linear(encoded: f32) -> f32 {
    if encoded <= 0.040_45 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

fn alpha_alone(pair: &Pair<'_>) -> Tried {
    let pixels = pair.image.pixels.iter().zip(&pair.exact.pixels);
    let left = pixels.filter(|(image, exact)| {
        let alpha = image.a;
        !pair.same(
            image,
            &Rgba {
                a: alpha,
                ..**exact
            },
        )
    });
    Tried::new(
        left.count(),
        "Only alpha differs, all colours are equal. The exact image has the alpha of what is in front of an opaque \
         background.",
    )
}

/// Compares each pixel of the image, multiplied by its alpha, with the exact one.
fn unmultiplied(pair: &Pair<'_>) -> usize {
    let pixels = pair.image.pixels.iter().zip(&pair.exact.pixels);
    let left = pixels.filter(|(image, exact)| {
        let Rgba { r, g, b, a } = **image;
        !pair.same(&Rgba::new(r * a, g * a, b * a, a), exact)
    });
    left.count()
}

/// Red, green and blue in another order.
fn swapped(pair: &Pair<'_>) -> Vec<Tried> {
    const ORDERS: [([usize; 3], &str); 5] = [
        ([2, 1, 0], "BGR"),
        ([0, 2, 1], "RBG"),
        ([1, 0, 2], "GRB"),
        ([1, 2, 0], "GBR"),
        ([2, 0, 1], "BRG"),
    ];
    let tried = ORDERS.map(|(order, name)| {
        let left = pair.left(|p| {
            let channels = [p.r, p.g, p.b];
            let [r, g, b] = order.map(|channel| channels[channel]);
            Rgba::new(r, g, b, p.a)
        });
        let sentence = format!("The image's channels are in another order: {name} instead of RGB.");
        Tried::new(left, sentence)
    });
    tried.into()
}

/// All colours multiplied by one factor, which is the median of the pixels' factors. 8 bits end at 1.
fn scaled(pair: &Pair<'_>) -> Option<Tried> {
    let mut factors = Vec::new();
    for (image, exact) in pair.image.pixels.iter().zip(&pair.exact.pixels) {
        for (a, b) in [(image.r, exact.r), (image.g, exact.g), (image.b, exact.b)] {
            // The factor of small values is uncertain, and that of values at the end of the range is not known.
            let is_telling = b > 16.0 * pair.tolerance && a > 16.0 * pair.tolerance && a < 0.99;
            if is_telling {
                factors.push(a / b);
            }
        }
    }
    if factors.is_empty() {
        return None;
    }
    let middle = factors.len() / 2;
    let (_, &mut factor, _) = factors.select_nth_unstable_by(middle, f32::total_cmp);
    let left = pair.left(|p| colors(p, |v| v * factor));
    let clamped = pair.left(|p| colors(p, |v| (v * factor).min(1.0)));
    let sentence = format!("The image's colours are the exact ones times {factor:.3}.");
    Some(Tried::new(left.min(clamped), sentence))
}
