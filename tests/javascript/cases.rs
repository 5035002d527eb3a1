//! Random surfaces at a pixel.

use onionskin::low_level::emulator::{Group, Surface};
use onionskin::{Fragment, Rgba};
use serde_json::{Value, json};

use crate::chance::Chance;

/// A pixel's surfaces in the order of submission.
pub(crate) type Pixel = Vec<Surface>;

/// Pixels with up to 8 surfaces each.
pub(crate) fn random_pixels(seed: u64, count: usize) -> Vec<Pixel> {
    random_pixels_of(seed, count, 8)
}

/// Pixels with up to `most` surfaces each.
pub(crate) fn random_pixels_of(seed: u64, count: usize, most: usize) -> Vec<Pixel> {
    let mut chance = Chance::new(seed);
    (0..count).map(|_| random(&mut chance, most)).collect()
}

/// Surfaces on few depths or on many, the planes among them; some opaque ones, some sorted; in any order, or in
/// that of their depths; clear ones and solid ones.
fn random(chance: &mut Chance, most: usize) -> Pixel {
    let levels = [3, 6, 1 << 20][chance.below(3)];
    let depth = |chance: &mut Chance| chance.below(levels + 1) as f32 / levels as f32;
    let mut depths: Vec<f32> = (0..chance.below(most + 1)).map(|_| depth(chance)).collect();
    match chance.below(4) {
        0 => depths.sort_by(f32::total_cmp),
        1 => depths.sort_by(|a, b| b.total_cmp(a)),
        _ => {}
    }
    // One in three pixels has opaque surfaces.
    let opaque = [0, 0, 4][chance.below(3)];
    let surfaces = depths.into_iter().zip(0..).map(|(depth, order)| {
        let [r, g, b] = chance.color();
        let group = match chance.below(12) {
            it if it < opaque => Group::Opaque,
            it if it % 3 == 0 => Group::Sorted,
            _ => Group::Unsorted,
        };
        let alpha = match (group, chance.below(8)) {
            (Group::Opaque, _) | (_, 0) => 1.0,
            (_, 1) => 0.0,
            _ => chance.unit() as f32,
        };
        Surface {
            fragment: Fragment {
                depth,
                color: Rgba::new(r, g, b, alpha),
                order,
            },
            group,
        }
    });
    surfaces.collect()
}

/// The surfaces as node takes them.
pub(crate) fn json(pixel: &Pixel) -> Value {
    let surface = |surface: &Surface| {
        let Fragment { depth, color, .. } = surface.fragment;
        json!([
            depth,
            color.r,
            color.g,
            color.b,
            color.a,
            group(surface.group)
        ])
    };
    pixel.iter().map(surface).collect()
}

fn group(group: Group) -> &'static str {
    match group {
        Group::Opaque => "opaque",
        Group::Sorted => "sorted",
        Group::Unsorted | Group::Proxy => "unsorted",
    }
}

/// The pixel without one of its surfaces, whose places in the order of submission close up.
pub(crate) fn without(pixel: &Pixel, place: usize) -> Pixel {
    let mut fewer = pixel.clone();
    fewer.remove(place);
    for (surface, order) in fewer.iter_mut().zip(0..) {
        surface.fragment.order = order;
    }
    fewer
}
