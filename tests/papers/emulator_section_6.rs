//! Section 6 of Carr et al. (2008) on the emulated pixel: one float-blending pass instead of two passes that count (C17), and
//! its printed blend factors against the sentence that describes them (C18).

use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::papers::carr_2008::{D_SN, Z_MIN_PREV};
use onionskin::low_level::steps::{Amendment, Format};

use crate::kit::peels::{Loop, Pixel, depth_of, pixel, random_image, tied_image};

/// What one iteration leaves of `D(sn)` and `z_min_prev`, and how often it drew the transparent geometry.
fn first_iteration(
    which: Loop,
    pixels: &[Pixel],
    amendments: &[Amendment],
) -> (Vec<[f32; 2]>, usize) {
    let mut emulator = Emulator::new(pixels.to_vec()).watching(0);
    which.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
    which.run(&mut emulator, amendments, 1.0);
    let prev: Vec<f32> = match which {
        Loop::B => {
            let colors = emulator.colors(Z_MIN_PREV).unwrap();
            colors.iter().map(|color| color[0]).collect()
        }
        _ => emulator.depths(Z_MIN_PREV).unwrap().to_vec(),
    };
    let nearest = emulator.depths(D_SN).unwrap().iter();
    let found = nearest.zip(prev).map(|(&sn, prev)| [sn, prev]).collect();
    // OPAQUE_FIRST draws once more, opaque objects.
    (found, emulator.record().draws.len() - 1)
}

/// "Both pass 1 and 2 can be replaced by a single pass bringing the total count to five."
#[test]
pub(crate) fn c17_one_pass_of_float_blending_finds_what_passes_1_and_2_find() {
    for pixels in [
        random_image(1),
        random_image(8),
        random_image(32),
        tied_image(8, 4),
    ] {
        let [(a, six), (b, five)] =
            [Loop::A, Loop::B].map(|which| first_iteration(which, &pixels, &which.amendments()));
        assert_eq!(a, b);
        assert_eq!((six, five), (6, 5));
        // Something precedes s_n out of order at some pixels, where there is more than one surface.
        let bounded = a.iter().filter(|[_, prev]| *prev < 1.0).count();
        assert_eq!(bounded > 100, pixels[0].len() > 1);
    }
}

/// "Store the depth of the surface that was previously closest to the camera": past 255 descending surfaces the stencil
/// cannot, and the blending pass still does.
#[test]
pub(crate) fn c17_the_blending_pass_does_not_overflow() {
    let pixels = vec![pixel((0..300).rev().map(|k| depth_of(k, 300)))];
    let previous = |which: Loop| first_iteration(which, &pixels, &which.amendments()).0[0][1];
    assert_eq!(previous(Loop::B), depth_of(1, 300));
    assert!(previous(Loop::A) > depth_of(1, 300));
}

/// "A blend method that multiplies the source color by the destination alpha" moves the last depth into the color. The
/// printed factors multiply the destination color by it: the color becomes the product of all earlier depths.
#[test]
pub(crate) fn c18_the_sentence_moves_one_depth_and_the_printed_factors_multiply_all() {
    let mut differ = 0;
    for n in 1..=12 {
        let depths: Vec<f32> = (0..n).rev().map(|k| depth_of(k, n)).collect();
        let pixels = [pixel(depths.iter().copied())];
        let color =
            |amendments: &[Amendment]| first_iteration(Loop::B, &pixels, amendments).0[0][1];
        let before = &depths[..n - 1];
        let sentence = before.last().copied().unwrap_or(1.0);
        let product = before.iter().product::<f32>();
        assert_eq!(color(&Loop::B.amendments()), sentence, "{n}");
        assert_eq!(color(&Loop::B.without("CX16")), product, "{n}");
        // Right by chance up to two surfaces that lower the depth, because the color was cleared to 1.
        assert_eq!(product == sentence, n <= 2, "{n}");
        differ += usize::from(product < depths[n - 1]);
    }
    // Where the product lies before s_n itself, the range is empty, and the loop ends with nothing composited.
    assert!(differ > 5, "{differ}");
}
