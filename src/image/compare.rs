//! How two pictures differ.

use super::Image;
use crate::error::{Error, Result};
use crate::fragment::Rgba;

/// The differences of two pictures of the same size, channel by channel, 0 to 1. Two infinities of the same sign are
/// equal. If either value is not a number, the difference is infinite, so that it is over every bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// The largest difference of any channel.
    pub max: f64,
    /// The mean over all channels.
    pub mean: f64,
    /// The root of the mean square over all channels.
    pub rms: f64,
    /// 99 of 100 pixels differ by at most this in every channel.
    pub percentile_99: f64,
    /// The bound that the caller gave.
    pub bound: f64,
    /// The number of pixels with a channel that differs by more than the bound.
    pub over: usize,
    /// The column and the row, from the top left, of the pixel with the largest difference. `None` if there is no
    /// difference.
    pub worst: Option<[u32; 2]>,
}

impl Comparison {
    /// Compares two pictures, and counts the pixels that differ by more than `bound` in a channel.
    ///
    /// # Errors
    /// If their sizes differ.
    pub fn new(a: &Image, b: &Image, bound: f64) -> Result<Self> {
        Self::among(a, b, bound, |_| true)
    }

    /// Compares only the pixels for which `among` is true. It gets a pixel's number, row by row from the top. If it is
    /// true for no pixel, the pictures do not differ.
    ///
    /// # Errors
    /// If their sizes differ.
    pub fn among(a: &Image, b: &Image, bound: f64, among: impl Fn(usize) -> bool) -> Result<Self> {
        if (a.width, a.height) != (b.width, b.height) {
            return Err(Error::SizesDiffer {
                a: [a.width, a.height],
                b: [b.width, b.height],
            });
        }
        let (mut sum, mut squares) = (0.0, 0.0);
        let mut worst = (0.0, None);
        let mut pixels = Vec::with_capacity(a.pixels.len());
        let pairs = a.pixels.iter().zip(&b.pixels).enumerate();
        for (index, (&a_pixel, &b_pixel)) in pairs.filter(|(index, _)| among(*index)) {
            let channels = differences(a_pixel, b_pixel);
            sum += channels.iter().sum::<f64>();
            squares += channels.iter().map(|d| d * d).sum::<f64>();
            let largest = channels.into_iter().fold(0.0, f64::max);
            if largest > worst.0 {
                let (x, y) = (index as u32 % a.width, index as u32 / a.width);
                worst = (largest, Some([x, y]));
            }
            pixels.push(largest);
        }
        let channels = (pixels.len() * 4).max(1) as f64;
        let over = pixels.iter().filter(|&&d| d > bound).count();
        pixels.sort_unstable_by(f64::total_cmp);
        let rank = (pixels.len() * 99).div_ceil(100).saturating_sub(1);
        Ok(Self {
            max: worst.0,
            mean: sum / channels,
            rms: (squares / channels).sqrt(),
            percentile_99: pixels.get(rank).copied().unwrap_or(0.0),
            bound,
            over,
            worst: worst.1,
        })
    }
}

impl Comparison {
    /// The largest difference of a channel for each pixel, in the pictures' order.
    ///
    /// # Errors
    /// If their sizes differ.
    pub fn pixels(a: &Image, b: &Image) -> Result<Vec<f64>> {
        Self::new(a, b, 0.0)?;
        let pairs = a.pixels.iter().zip(&b.pixels);
        let largest = pairs.map(|(&a, &b)| differences(a, b).into_iter().fold(0.0, f64::max));
        Ok(largest.collect())
    }
}

/// The largest difference of a channel.
pub(crate) fn difference(a: Rgba, b: Rgba) -> f64 {
    differences(a, b).into_iter().fold(0.0, f64::max)
}

fn differences(a: Rgba, b: Rgba) -> [f64; 4] {
    let (a, b) = (a.to_array(), b.to_array());
    std::array::from_fn(|channel| {
        let (a, b) = (f64::from(a[channel]), f64::from(b[channel]));
        let difference = (a - b).abs();
        if a == b {
            0.0
        } else if difference.is_nan() {
            f64::INFINITY
        } else {
            difference
        }
    })
}

/// Both pictures and their difference side by side. The difference is multiplied by `gain`, so that small differences
/// can be seen. Black means equal; red, green and blue show the channels that differ.
///
/// # Errors
/// If their sizes differ.
pub fn difference_picture(a: &Image, b: &Image, gain: f32) -> Result<Image> {
    let difference = differences_alone(a, b, gain)?;
    Ok(Image::beside(
        &[a, b, &difference],
        4,
        Rgba::opaque([0.5; 3]),
    ))
}

/// The difference of both pictures, as [`difference_picture`] has it beside them.
///
/// # Errors
/// If their sizes differ.
pub(crate) fn differences_alone(a: &Image, b: &Image, gain: f32) -> Result<Image> {
    Comparison::new(a, b, 0.0)?;
    let pixels = a.pixels.iter().zip(&b.pixels).map(|(&a, &b)| {
        let [red, green, blue, alpha] = differences(a, b).map(|d| (d as f32 * gain).min(1.0));
        // A difference in alpha alone shows in grey.
        Rgba::new(red.max(alpha), green.max(alpha), blue.max(alpha), 1.0)
    });
    Ok(Image {
        width: a.width,
        height: a.height,
        pixels: pixels.collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image(values: &[f32]) -> Image {
        let pixels = values
            .iter()
            .map(|&v| Rgba::new(v, 0.0, 0.0, 1.0))
            .collect();
        Image {
            width: values.len() as u32,
            height: 1,
            pixels,
        }
    }

    #[test]
    fn equal_pictures_do_not_differ() {
        let a = image(&[0.0, 0.25, 1.0]);
        let comparison = Comparison::new(&a, &a, 0.0).unwrap();
        assert_eq!(
            (
                comparison.max,
                comparison.mean,
                comparison.rms,
                comparison.over
            ),
            (0.0, 0.0, 0.0, 0)
        );
        assert_eq!(comparison.worst, None);
    }

    #[test]
    fn one_channel_of_one_pixel_is_noticed_and_found() {
        let comparison =
            Comparison::new(&image(&[0.0, 0.5, 1.0]), &image(&[0.0, 0.75, 1.0]), 0.2).unwrap();
        assert_eq!(
            (comparison.max, comparison.over, comparison.worst),
            (0.25, 1, Some([1, 0]))
        );
        assert_eq!(comparison.mean, 0.25 / 12.0);
        assert_eq!(comparison.rms, (0.25_f64.powi(2) / 12.0).sqrt());
    }

    #[test]
    fn a_difference_equal_to_the_bound_is_within_it() {
        assert_eq!(
            Comparison::new(&image(&[0.0]), &image(&[0.25]), 0.25)
                .unwrap()
                .over,
            0
        );
    }

    #[test]
    fn not_a_number_is_over_every_bound() {
        let comparison = Comparison::new(&image(&[f32::NAN]), &image(&[0.0]), 1e300).unwrap();
        assert_eq!((comparison.max, comparison.over), (f64::INFINITY, 1));
    }

    #[test]
    fn the_percentile_leaves_one_pixel_of_a_hundred_out() {
        let mut values = vec![0.0; 200];
        values[7] = 1.0;
        values[9] = 1.0;
        let comparison = Comparison::new(&image(&values), &image(&[0.0; 200]), 0.0).unwrap();
        assert_eq!(comparison.percentile_99, 0.0);
        values[11] = 1.0;
        let comparison = Comparison::new(&image(&values), &image(&[0.0; 200]), 0.0).unwrap();
        assert_eq!(comparison.percentile_99, 1.0);
    }

    #[test]
    fn what_does_not_count_makes_no_difference() {
        let (a, b) = (image(&[0.0, 0.5, 1.0]), image(&[0.0, 0.75, 0.0]));
        let comparison = Comparison::among(&a, &b, 0.2, |pixel| pixel < 2).unwrap();
        assert_eq!((comparison.max, comparison.over), (0.25, 1));
        let none = Comparison::among(&a, &b, 0.2, |_| false).unwrap();
        assert_eq!(
            (none.max, none.mean, none.over, none.worst),
            (0.0, 0.0, 0, None)
        );
    }

    #[test]
    fn pictures_of_different_sizes_are_refused() {
        let error = Comparison::new(&image(&[0.0]), &image(&[0.0, 0.0]), 0.0).unwrap_err();
        assert!(error.to_string().contains("1 x 1"), "{error}");
    }

    #[test]
    fn the_difference_picture_has_three_panels() {
        let picture = difference_picture(&image(&[0.0, 0.5]), &image(&[0.0, 0.25]), 2.0).unwrap();
        assert_eq!((picture.width, picture.height), (2 * 3 + 2 * 4, 1));
        assert_eq!(picture.pixel(12, 0), Rgba::opaque([0.0; 3]));
        assert_eq!(picture.pixel(13, 0), Rgba::opaque([0.5, 0.0, 0.0]));
    }
}
