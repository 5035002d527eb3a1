//! Peeled layers as pictures.

use crate::fragment::Rgba;
use crate::image::Image;
use crate::methods::Layer;

const WHITE: Rgba = Rgba::opaque([1.0; 3]);

/// A layer as an opaque picture over white. The layer is where its depth lies before the far plane.
pub fn opaque(layer: &Layer) -> Image {
    let texels = layer.color.pixels.iter().zip(&layer.depth);
    let pixels = texels.map(|(&color, &depth)| match depth < 1.0 {
        true => Rgba { a: 1.0, ..color },
        false => WHITE,
    });
    Image {
        pixels: pixels.collect(),
        ..layer.color
    }
}

/// Window-space depths, row by row from the top, in grey, from dark (nearest) to light (farthest). What is at the far plane
/// is white.
///
/// # Panics
/// If the last row is not whole.
pub fn depths(width: u32, depths: &[f32]) -> Image {
    let height = depths.len() as u32 / width.max(1);
    assert_eq!(width as usize * height as usize, depths.len(), "whole rows");
    let some = || depths.iter().copied().filter(|&depth| depth < 1.0);
    let nearest = some().fold(1.0, f32::min);
    let farthest = some().fold(0.0, f32::max);
    let grey = |&depth: &f32| {
        let along = (depth - nearest) / (farthest - nearest).max(f32::MIN_POSITIVE);
        let grey = if depth < 1.0 { 0.8 * along } else { 1.0 };
        Rgba::opaque([grey; 3])
    };
    Image {
        width,
        height,
        pixels: depths.iter().map(grey).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_is_black_the_farthest_light_and_nothing_white() {
        let picture = depths(2, &[0.25, 0.5, 0.75, 1.0]);
        assert_eq!([picture.width, picture.height], [2, 2]);
        let greys: Vec<_> = picture.pixels.iter().map(|it| it.r).collect();
        assert_eq!(greys, [0.0, 0.4, 0.8, 1.0]);
    }
}
