//! What of each fragment is in a method's image, found by asking the method.
//!
//! A pixel's colour is a sum of the fragments' colours, each with a weight. So everything that was done is done again with
//! black fragments but for three: one is red, one green, one blue. The channels of the image are their weights.
//!
//! Weights tell the order, too. Composited front to back with an opacity `a` for every fragment, the k-th from the front has
//! the weight `a (1 - a)^k`. So with this opacity for all fragments, the weights say the places. This works for every method
//! that composites fragments one by one, however it does so, and tells those that do not.
//!
//! Volumes are made clear for both: weights and places are those of the surfaces among themselves.

use super::recording::{Done, Place};
use crate::emulator::{Emulator, Group, Surface};
use crate::error::Result;
use crate::fragment::{Fragment, Rgba};
use crate::papers::stage::IMAGE_COLOR;
use crate::steps::Format;

/// The opacity of every one of so many fragments for finding places: a power of two, which 16-bit floats hold exactly.
///
/// Methods add up what the layers stop, so what is left for the next one has an error of some 2^-24 a layer, whatever is left.
/// It must stay a small part of it. With a sixteenth for each, too little is left after a hundred layers. With at most two
/// over their number, an eighth is left behind the last of them.
fn opacity(fragments: usize) -> f32 {
    let halvings = fragments.max(1).ilog2().max(4);
    0.5_f32.powi(halvings as i32)
}

/// By how much of itself the weight of the place behind so many layers may be off, of so many fragments: roundings of 2^-24 a
/// layer, of what is at least an eighth, and as much again for what a method adds. Next places differ by the opacity, so it is
/// less than a fourth of that.
fn tolerance(layers: i32, opacity: f64) -> f64 {
    (f64::from(layers + 8) * 2.0_f64.powi(-20)).min(opacity / 4.0)
}

/// The fragments in a method's image, nearest first, each by its number. `None` if they are not composited one by one.
///
/// # Errors
/// What the emulated pixel leaves out.
pub(super) fn composited(
    place: &Place,
    surfaces: &[Surface],
    done: &[Done],
) -> Result<Option<Vec<u32>>> {
    let opacity = opacity(surfaces.len());
    let weights = weights_with(place, surfaces, done, |_| opacity)?;
    let mut weights: Vec<_> = weights.into_iter().zip(0..).collect();
    weights.retain(|(weight, _)| *weight != 0.0);
    weights.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let opacity = f64::from(opacity);
    let are_places = (0..).zip(&weights).all(|(k, (weight, _))| {
        let expected = opacity * (1.0 - opacity).powi(k);
        (weight / expected - 1.0).abs() < tolerance(k, opacity)
    });
    let numbers = weights.into_iter().map(|(_, number)| number);
    Ok(are_places.then(|| numbers.collect()))
}

/// The part of each fragment's colour that is in a method's image.
///
/// # Errors
/// What the emulated pixel leaves out.
pub(super) fn weights(place: &Place, surfaces: &[Surface], done: &[Done]) -> Result<Vec<f64>> {
    weights_with(place, surfaces, done, |surface| surface.fragment.color.a)
}

/// The weights of transparent fragments with other opacities. That of an opaque one is 0, and so is that of a volume's box.
fn weights_with(
    place: &Place,
    surfaces: &[Surface],
    done: &[Done],
    opacity: impl Fn(&Surface) -> f32,
) -> Result<Vec<f64>> {
    let mut weights = vec![0.0; surfaces.len()];
    let place = &place.with_clear_volumes();
    let is_transparent =
        |number: &usize| matches!(surfaces[*number].group, Group::Sorted | Group::Unsorted);
    let transparent: Vec<_> = (0..surfaces.len()).filter(is_transparent).collect();
    for numbers in transparent.chunks(3) {
        let lit = surfaces.iter().enumerate().map(|(number, surface)| {
            let channel = numbers.iter().position(|&lit| lit == number);
            Surface {
                fragment: Fragment {
                    color: color(surface, channel, opacity(surface)),
                    ..surface.fragment
                },
                ..*surface
            }
        });
        let image = image(place, lit.collect(), done)?;
        for (number, weight) in numbers.iter().zip(image) {
            weights[*number] = f64::from(weight);
        }
    }
    Ok(weights)
}

/// Black, but for one channel.
fn color(surface: &Surface, channel: Option<usize>, opacity: f32) -> Rgba {
    let value = |of: usize| f32::from(u8::from(channel == Some(of)));
    match surface.group {
        Group::Opaque => Rgba::opaque([0.0; 3]),
        Group::Proxy => Rgba::default(),
        _ => Rgba::new(value(0), value(1), value(2), opacity),
    }
}

/// The image after everything has been done again, before a black background.
fn image(place: &Place, surfaces: Vec<Surface>, done: &[Done]) -> Result<[f32; 3]> {
    let mut emulator: Emulator = place.emulator(surfaces);
    for done in done {
        fine_and_black(done).repeat(&mut emulator)?;
    }
    let [r, g, b, _] = emulator.colors(IMAGE_COLOR)?[0];
    Ok([r, g, b])
}

/// The step before a black background, and with maps of 32-bit floats for colours, whose rounding says nothing about places.
fn fine_and_black(done: &Done) -> Done {
    match done {
        Done::Map(map, Format::Rgba8 | Format::Rgba16F | Format::Rgb10A2) => {
            Done::Map(*map, Format::Rgba32F)
        }
        Done::Background(_) => Done::Background([0.0; 3]),
        done => done.clone(),
    }
}
