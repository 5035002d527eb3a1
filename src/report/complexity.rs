//! The depth complexity image as a picture, and its histogram as a table.

use std::fmt::Write;

use crate::fragment::Rgba;
use crate::image::Image;
use crate::methods::Complexity;

/// The depth complexity image, rescaled and inverted as in figure 1 of Lindholm et al. 2015. A white pixel has no
/// fragment, a black one the most.
pub fn picture(complexity: &Complexity) -> Image {
    let max = complexity.max().max(1) as f32;
    let pixel = |&count: &u32| {
        let grey = 1.0 - count as f32 / max;
        Rgba::opaque([grey; 3])
    };
    Image {
        width: complexity.width,
        height: complexity.height,
        pixels: complexity.counts.iter().map(pixel).collect(),
    }
}

/// The histogram with bins of `bin` complexities, as CSV: a line of names, then a line for each bin, including empty
/// ones. `part` is the bin's part of all pixels, 0 to 1.
pub fn csv(complexity: &Complexity, bin: u32) -> String {
    let pixels = complexity.counts.len().max(1) as f64;
    let mut text = String::from("from,to,pixels,part\n");
    for bin in complexity.histogram(bin) {
        let part = bin.pixels as f64 / pixels;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{},{},{},{part:.6}", bin.from, bin.to, bin.pixels);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complexity() -> Complexity {
        Complexity {
            width: 2,
            height: 2,
            counts: vec![0, 1, 4, 2],
        }
    }

    #[test]
    fn the_deepest_pixel_is_black_and_an_empty_one_white() {
        let picture = picture(&complexity());
        assert_eq!(picture.pixel(0, 0), Rgba::opaque([1.0; 3]));
        assert_eq!(picture.pixel(0, 1), Rgba::opaque([0.0; 3]));
        assert_eq!(picture.pixel(1, 1), Rgba::opaque([0.5; 3]));
    }

    #[test]
    fn the_table_has_every_bin_and_every_pixel() {
        assert_eq!(
            csv(&complexity(), 2),
            "from,to,pixels,part\n0,1,2,0.500000\n2,3,1,0.250000\n4,5,1,0.250000\n"
        );
    }
}
