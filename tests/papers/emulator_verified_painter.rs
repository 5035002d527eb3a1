//! The proof of the verified painter, on the emulated pixel: every order of few surfaces, with every pattern of equal
//! depths, with and without an opaque surface anywhere among them.

use onionskin::low_level::emulator::{Emulator, Group, run_on_lists};
use onionskin::low_level::fragment::Fragment;
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::edition::{BLEND_AND_PROVE, PROOF_DEPTH, RESOURCES};
use onionskin::low_level::papers::lindholm_2015::components;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Amendment, Variables, gl::*, run};
use onionskin::{Format, steps};

use crate::emulator_exhaustive::cases;
use crate::kit::bounds;
use crate::kit::changed::changed;
use crate::kit::peels::{self, Pixel, expected, expected_color, opaque_depth};

/// Pixels at a time.
const IMAGE: usize = 6000;

/// Runs the verified pass: each pixel's colour, and how many of its fragments failed.
fn verified(pixels: &[Pixel], amendments: &[Amendment]) -> (Vec<[f32; 4]>, Vec<u8>) {
    let mut emulator = Emulator::new(pixels.to_vec());
    let resources = [&stage::RESOURCES, &RESOURCES];
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut emulator, &resources, color, depth).unwrap();
    for (listing, amendments) in [
        (&stage::OPAQUE_FIRST, &[][..]),
        (&BLEND_AND_PROVE, amendments),
    ] {
        run(listing, amendments, Variables::new(), &mut emulator).unwrap();
    }
    let colors = emulator.colors(stage::IMAGE_COLOR).unwrap().to_vec();
    (colors, emulator.stencils(PROOF_DEPTH).unwrap().to_vec())
}

/// The depths of the pixel's fragments that nothing opaque hides, as they were submitted.
fn visible(pixel: &Pixel) -> Vec<Fragment> {
    let opaque = opaque_depth(pixel);
    let surfaces = pixel
        .iter()
        .filter(|surface| surface.group != Group::Opaque);
    let fragments = surfaces.map(|surface| surface.fragment);
    fragments
        .filter(|fragment| fragment.depth < opaque)
        .collect()
}

fn is_strictly_back_to_front(pixel: &Pixel) -> bool {
    visible(pixel)
        .windows(2)
        .all(|pair| pair[0].depth > pair[1].depth)
}

fn is_exact(pixel: &Pixel, color: [f32; 4]) -> bool {
    let bound = bounds::composited(pixel.len() as u32);
    let channels = color.into_iter().zip(expected_color(pixel)).take(3);
    channels
        .into_iter()
        .all(|(a, b)| (f64::from(a) - b).abs() <= bound)
}

/// The number of pixels whose mark is wrong, and of those without a mark that are not exact.
fn wrong(amendments: &[Amendment]) -> [usize; 2] {
    let mut wrong = [0; 2];
    for image in cases().chunks(IMAGE) {
        let (colors, failed) = verified(image, amendments);
        for ((pixel, color), failed) in image.iter().zip(colors).zip(failed) {
            wrong[0] += usize::from((failed == 0) != is_strictly_back_to_front(pixel));
            wrong[1] += usize::from(failed == 0 && !is_exact(pixel, color));
        }
    }
    wrong
}

#[test]
fn a_pixel_is_unmarked_exactly_if_its_depths_fall_strictly_and_then_it_is_exact() {
    let all = cases();
    let unmarked = all.iter().filter(|pixel| is_strictly_back_to_front(pixel));
    // Both kinds are there in numbers.
    let unmarked = unmarked.count();
    assert!(
        unmarked > 10_000 && all.len() - unmarked > 100_000,
        "{unmarked}"
    );
    assert_eq!(wrong(&[]), [0, 0]);
}

/// What is marked goes into lists, where the pseudocode of ppDP resolves it: every case comes out in order.
#[test]
fn every_marked_pixel_comes_out_right_by_its_list() {
    let all = cases();
    let marked: Vec<&Pixel> = all
        .iter()
        .filter(|pixel| !is_strictly_back_to_front(pixel))
        .collect();
    let lists: Vec<_> = marked.iter().map(|pixel| visible(pixel)).collect();
    let resolved = run_on_lists(
        &components::PP_DP,
        &components::PP_DP_AMENDMENTS,
        &lists,
        4,
        10,
    )
    .unwrap();
    assert!(resolved.ended);
    for (pixel, resolved) in marked.into_iter().zip(&resolved.pixels) {
        assert_eq!(resolved.composited, expected(pixel));
    }
}

#[test]
fn a_changed_word_of_the_proof_is_noticed() {
    const LESS_OR_EQUAL: Amendment = changed(
        steps! { glDepthFunc(LESS); },
        steps! { glDepthFunc(LEQUAL); },
    );
    const NO_MARK: Amendment = changed(
        steps! { glStencilOp(KEEP, INCR, KEEP); },
        steps! { glStencilOp(KEEP, KEEP, KEEP); },
    );
    const NEARER: Amendment = changed(
        steps! { glClearDepth(1.0); },
        steps! { glClearDepth(0.25); },
    );
    let [marks, colors] = wrong(&[LESS_OR_EQUAL]);
    // Ties pass, and the one drawn last comes to lie in front.
    assert!(marks > 1000 && colors > 1000, "{marks} {colors}");
    let [marks, colors] = wrong(&[NO_MARK]);
    assert!(marks > 1000 && colors > 1000, "{marks} {colors}");
    let [marks, _] = wrong(&[NEARER]);
    assert!(marks > 500, "{marks}");
}

#[test]
fn a_pixel_with_more_failures_than_the_stencil_counts_stays_marked() {
    let front_to_back = peels::sorted(600);
    let (_, failed) = verified(&front_to_back, &[]);
    assert_eq!(failed, [255]);
}
