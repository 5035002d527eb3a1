//! Mistakes about the background.

use std::collections::HashMap;

use super::pair::{Pair, Tried};
use crate::fragment::Rgba;

pub(super) fn tried(pair: &Pair<'_>, background: [f32; 3]) -> Vec<Tried> {
    let mut tried = vec![
        Tried::new(
            over_background(pair, background, true),
            "The image has a transparent background and premultiplied colours. Composite it over the scene's background.",
        ),
        Tried::new(
            over_background(pair, background, false),
            "The image has a transparent background and straight colours. Composite it over the scene's background.",
        ),
    ];
    tried.extend(another(pair, background));
    tried
}

/// Compares the image, composited over the background, with the exact one.
fn over_background(pair: &Pair<'_>, [r, g, b]: [f32; 3], is_premultiplied: bool) -> usize {
    let pixels = pair.image.pixels.iter().zip(&pair.exact.pixels);
    let left = pixels.filter(|(image, exact)| {
        let own = if is_premultiplied { 1.0 } else { image.a };
        let behind = 1.0 - image.a;
        let over = Rgba::new(
            image.r * own + r * behind,
            image.g * own + g * behind,
            image.b * own + b * behind,
            exact.a,
        );
        !pair.same(&over, exact)
    });
    left.count()
}

/// The image has another background colour. Elsewhere it differs by the part of that colour that shines through, which
/// is between 0 and 1.
fn another(pair: &Pair<'_>, [r, g, b]: [f32; 3]) -> Option<Tried> {
    let there = commonest_of_background(pair, Rgba::opaque([r, g, b]))?;
    let from = [r, g, b];
    let change = [there[0] - r, there[1] - g, there[2] - b];
    let largest = (0..3).max_by(|&i, &j| change[i].abs().total_cmp(&change[j].abs()))?;
    if change[largest].abs() <= pair.tolerance {
        return None;
    }
    let pixels = pair.image.pixels.iter().zip(&pair.exact.pixels);
    let left = pixels.filter(|(image, exact)| {
        let part = channels(image)[largest] - channels(exact)[largest];
        let part = (part / change[largest]).clamp(0.0, 1.0);
        let [r, g, b] = [0, 1, 2].map(|i| channels(exact)[i] + part * change[i]);
        !pair.same(image, &Rgba::new(r, g, b, exact.a))
    });
    let sentence = format!(
        "The image has another background: {} instead of {}.",
        words(there),
        words(from)
    );
    Some(Tried::new(left.count(), sentence))
}

/// The colour that the image has most often where the exact one has its background.
fn commonest_of_background(pair: &Pair<'_>, background: Rgba) -> Option<[f32; 3]> {
    let mut counts: HashMap<[u32; 3], usize> = HashMap::new();
    for (image, exact) in pair.image.pixels.iter().zip(&pair.exact.pixels) {
        if pair.same(exact, &background) {
            *counts.entry(channels(image).map(f32::to_bits)).or_default() += 1;
        }
    }
    // Of two equally common colours, it is always the same one.
    let (bits, _) = counts
        .into_iter()
        .max_by_key(|&(bits, count)| (count, bits))?;
    Some(bits.map(f32::from_bits))
}

fn channels(pixel: &Rgba) -> [f32; 3] {
    [pixel.r, pixel.g, pixel.b]
}

fn words([r, g, b]: [f32; 3]) -> String {
    format!("[{r:.3}, {g:.3}, {b:.3}]")
}
