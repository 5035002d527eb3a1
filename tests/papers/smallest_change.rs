//! Amendments are small: one step less, and the failure is back. Each amendment that runs on the emulated pixel is left out
//! whole, and then without each single step that it adds. A change is noticed if the image, the iterations or the end of the
//! loop are others than by the whole amendment.
//!
//! Those that need OpenGL are in `tests/gl/smallest_change.rs`.

use onionskin::low_level::emulator::{Group, run_algorithm, run_on_lists};
use onionskin::low_level::fragment::{Fragment, Rgba};
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::papers::lindholm_2015::{components, fused};
use onionskin::low_level::steps::{Amendment, Reading};

use crate::emulator_exhaustive::{partly_sorted, sequences_with_ties, with_every_opaque};
use crate::emulator_fused;
use crate::kit::peels::{self, Loop, Pixel, before, depth_of, emulate, random_image, reversed};
use crate::kit::shortened::idle;

/// Every sequence of up to four surfaces with every tie and every opaque surface; the same from the near plane on; random
/// images, in which pixels end at different iterations.
fn images() -> Vec<Vec<Pixel>> {
    let small = (1..=4).flat_map(sequences_with_ties);
    let small: Vec<Pixel> = small
        .flat_map(|ranks| with_every_opaque(&ranks).collect::<Vec<_>>())
        .collect();
    let mut near = small.clone();
    for surface in near.iter_mut().flatten() {
        surface.fragment.depth -= 2.0 / 32.0;
    }
    let half = random_image(8)
        .into_iter()
        .map(|pixel| before(pixel, depth_of(4, 8)))
        .collect();
    vec![small, near, random_image(8), half, reversed(16)]
}

fn of_loop(
    which: Loop,
    images: &[Vec<Pixel>],
    amendments: &[Amendment],
) -> Vec<impl PartialEq + use<>> {
    let run = |pixels: &Vec<Pixel>| {
        let emulated = emulate(which, pixels, amendments);
        let image = emulated.emulator.colors(peels::IMAGE).unwrap();
        let image: Vec<_> = image.iter().map(|color| color.map(f32::to_bits)).collect();
        (image, emulated.iterations(), emulated.ended())
    };
    images.iter().map(run).collect()
}

#[test]
fn one_step_less_of_sections_5_and_6_is_noticed() {
    let images = images();
    let loops = [Loop::A, Loop::B];
    let right = loops.map(|which| of_loop(which, &images, &coherent::AMENDMENTS));
    let idle = idle(&coherent::AMENDMENTS, |amendments| {
        loops
            .iter()
            .zip(&right)
            .all(|(&which, right)| of_loop(which, &images, amendments) == *right)
    });
    assert_eq!(idle, Vec::<String>::new());
}

/// The images with each part of their surfaces sorted.
fn partly() -> Vec<Vec<Pixel>> {
    let parts = |pixels: Vec<Pixel>| -> Vec<Pixel> {
        let masks = [0b0101, 0b1100, 0b0010, 0];
        let part = |(place, pixel)| partly_sorted(pixel, masks[place % 4]);
        pixels.into_iter().enumerate().map(part).collect()
    };
    images().into_iter().map(parts).collect()
}

#[test]
fn one_step_less_of_algorithm_1_is_noticed() {
    let images = partly();
    assert!(
        images[0]
            .iter()
            .flatten()
            .any(|surface| surface.group == Group::Sorted)
    );
    let right = of_loop(Loop::Hybrid, &images, &hybrid::AMENDMENTS);
    let on_opengl = idle(&hybrid::AMENDMENTS, |amendments| {
        of_loop(Loop::Hybrid, &images, amendments) == right
    });
    assert_eq!(on_opengl, Vec::<String>::new());
    let run = |amendments: &[_]| {
        let run =
            |pixels: &Vec<Pixel>| run_algorithm(&hybrid::ALGORITHM_1, amendments, pixels, 20).ok();
        images.iter().map(run).collect::<Vec<_>>()
    };
    let right = run(&hybrid::AMENDMENTS_1);
    assert_eq!(
        idle(&hybrid::AMENDMENTS_1, |amendments| run(amendments) == right),
        Vec::<String>::new()
    );
}

#[test]
fn one_step_less_of_algorithm_2_is_noticed() {
    let images = images();
    let run = |amendments: &[_]| {
        let run =
            |pixels: &Vec<Pixel>| run_algorithm(&ideal::ALGORITHM_2, amendments, pixels, 40).ok();
        images.iter().map(run).collect::<Vec<_>>()
    };
    for whole in [&ideal::AMENDMENTS_2[..], &ideal::TIGHT_BOUND] {
        let right = run(whole);
        assert!(right.iter().all(Option::is_some));
        assert_eq!(
            idle(whole, |amendments| run(amendments) == right),
            Vec::<String>::new()
        );
    }
}

/// The filling of how ppDP's loop ends: once no fragment is lost, to wait for all of them is as good. Without the
/// corrections it is noticed.
const IDLE_AFTER_CORRECTIONS: [&str; 1] = ["LX03 3"];

#[test]
fn one_step_less_of_lindholm_s_components_is_noticed() {
    let lists: Vec<Vec<Fragment>> = (0..=40_u32)
        .map(|count| {
            let fragment = |order| Fragment {
                depth: (order * 7 % 5) as f32 / 8.0,
                color: Rgba::default(),
                order,
            };
            (0..count).map(fragment).collect()
        })
        .collect();
    let run = |algorithm, amendments: &[_], array| {
        run_on_lists(algorithm, amendments, &lists, array, 100)
            .ok()
            .map(|run| (run.pixels, run.ended))
    };
    // ppAO may peel every segment: one that holds the list takes one subpass.
    let filled = Reading::AsPrinted.of(&components::PP_DP_AMENDMENTS);
    for (algorithm, whole, array, harmless) in [
        (
            &components::PP_DP,
            &components::PP_DP_AMENDMENTS[..],
            3,
            &IDLE_AFTER_CORRECTIONS[..],
        ),
        (&components::PP_AO, &[components::PP_AO_AMENDMENT], 16, &[]),
        (&components::PP_DP, &filled, 3, &[]),
        (
            &components::STATIC_ARRAY,
            &[components::KEEP_NEAREST],
            8,
            &[],
        ),
    ] {
        let right = run(algorithm, whole, array);
        assert!(right.is_some());
        let idle = idle(whole, |amendments| {
            run(algorithm, amendments, array) == right
        });
        assert_eq!(idle, harmless, "{}", algorithm.title);
    }
}

/// On every list of two volumes, a pane and an opaque surface on four depths.
#[test]
fn one_step_less_of_section_6_1_is_noticed() {
    let cases = emulator_fused::cases();
    for (algorithm, whole, array, harmless) in [
        (&fused::FUSED, &fused::FUSED_AMENDMENTS[..], 9, &[][..]),
        (
            &fused::PP_DP_ON_RAYS,
            &fused::FUSED_PP_DP,
            2,
            &IDLE_AFTER_CORRECTIONS[..],
        ),
    ] {
        let run = |amendments: &[_]| -> Vec<_> {
            let run = |case: &emulator_fused::Case| {
                let (lists, rays) = case.try_to_run(algorithm, amendments, array).ok()?;
                let light = [
                    rays[0].light.map(f64::to_bits).to_vec(),
                    vec![rays[0].transparency.to_bits()],
                ];
                Some((lists.pixels, lists.ended, light))
            };
            cases.iter().map(run).collect()
        };
        let right = run(whole);
        assert!(right.iter().all(Option::is_some));
        let idle = idle(whole, |amendments| run(amendments) == right);
        assert_eq!(idle, harmless, "{}", algorithm.title);
    }
}
