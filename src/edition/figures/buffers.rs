//! Buffers as pictures.

use crate::fragment::Rgba;
use crate::image::Image;

/// Depths, bottom row first, as a picture: the nearest of the range is dark, the farthest light. What is 0 or 1 was cleared and
/// is white.
pub(super) fn grey_depths(width: u32, depths: &[f32], [near, far]: [f32; 2]) -> Image {
    let grey = |&depth: &f32| {
        if depth <= 0.0 || depth >= 1.0 {
            return [1.0; 4];
        }
        let along = (depth - near) / (far - near).max(f32::MIN_POSITIVE);
        let value = 0.05 + 0.75 * along.clamp(0.0, 1.0);
        [value, value, value, 1.0]
    };
    let texels: Vec<_> = depths.iter().map(grey).collect();
    Image::from_bottom_up(width, depths.len() as u32 / width.max(1), &texels)
}

/// A premultiplied picture over a colour.
pub(super) fn over(picture: &Image, behind: [f32; 3]) -> Image {
    let pixel = |it: &Rgba| {
        let rest = 1.0 - it.a;
        let [r, g, b] = behind;
        Rgba::opaque([it.r + rest * r, it.g + rest * g, it.b + rest * b])
    };
    Image {
        pixels: picture.pixels.iter().map(pixel).collect(),
        ..*picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_cleared_is_white_and_the_nearest_is_darkest() {
        let picture = grey_depths(4, &[0.0, 0.25, 0.75, 1.0], [0.25, 0.75]);
        let greys: Vec<f32> = picture.pixels.iter().map(|pixel| pixel.r).collect();
        assert_eq!([greys[0], greys[3]], [1.0, 1.0]);
        assert!(greys[1] < greys[2] && greys[2] < 1.0, "{greys:?}");
    }

    #[test]
    fn what_nothing_covers_has_the_colour_behind() {
        let mut picture = Image::filled(2, 1, Rgba::new(0.0, 0.0, 0.0, 0.0));
        picture.pixels[1] = Rgba::new(0.5, 0.0, 0.0, 0.5);
        let shown = over(&picture, [0.2, 0.4, 0.6]).pixels;
        assert_eq!(shown[0], Rgba::opaque([0.2, 0.4, 0.6]));
        assert_eq!(shown[1], Rgba::opaque([0.6, 0.2, 0.3]));
    }
}
