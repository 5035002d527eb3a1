//! Every error that was found in the printed text of Carr et al. (2008), keys CX01 to CX28: what happens as printed, on
//! images of 32 x 32 pixels, and that it does not as amended. CX01, CX02 and CX07 are in `papers/emulator_figure_2.rs`.

use crate::kit::peels;
use onionskin::low_level::emulator::{Emulator, run_algorithm};
use onionskin::low_level::papers::carr_2008::coherent::{self, CLEAN_STATE};
use onionskin::low_level::papers::carr_2008::{OPEN_CLOSED, OPEN_OPEN, hybrid, ideal};
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::gl::{COLOR_AND_DEPTH_BUFFER_BITS, DEPTH_BUFFER_BIT};
use onionskin::{Format, steps};

use crate::kit::chance::Chance;
use crate::kit::changed::changed;
use crate::kit::peels::{
    Emulated, Loop, Pixel, algorithm_2, amended, bad, before, depth_of, emulate, emulate_in,
    expected, expected_color, nearly_sorted_image, pixel, random_image, reversed, sorted,
    tied_image, without,
};

#[test]
pub(crate) fn cx04_a_closed_range_in_passes_3_and_4_costs_iterations() {
    for (pixels, iterations) in [
        (random_image(24), [25, 13]),
        (nearly_sorted_image(24), [25, 6]),
    ] {
        let right = amended(Loop::A, &pixels).iterations();
        let closed = without(Loop::A, "CX04", &pixels);
        assert_eq!(closed.bad(&pixels), 0);
        assert_eq!([closed.iterations(), right], iterations);
    }
}

#[test]
pub(crate) fn cx05_a_closed_range_in_pass_5_composites_the_bound_twice() {
    let pixels = random_image(8);
    assert!(without(Loop::A, "CX05", &pixels).bad(&pixels) > 1000);
    // With surfaces in order there is nothing at the bound.
    let pixels = sorted(8);
    assert_eq!(without(Loop::A, "CX05", &pixels).bad(&pixels), 0);
}

#[test]
pub(crate) fn cx06_a_range_that_is_open_below_loses_s_n() {
    // Section 4.2's "tight bound" (D(sn), ...], and its lower end alone.
    const AS_PRINTED: Amendment = changed(
        steps! { run coherent::RANGE_5; },
        steps! { run coherent::RANGE_5; glUseProgram(OPEN_CLOSED); },
    );
    const OPEN_BELOW: Amendment = changed(
        steps! { run coherent::RANGE_5; },
        steps! { run coherent::RANGE_5; glUseProgram(OPEN_OPEN); },
    );
    let pixels = random_image(8);
    amended(Loop::A, &pixels);
    // The nearest surface of all is the first iteration's s_n.
    let without_s_n = |run: &Emulated| {
        let composited = run.emulator.composited().iter();
        let lost =
            |(pixel, composited): &(&Pixel, &Vec<u32>)| !composited.contains(&expected(pixel)[0]);
        pixels.iter().zip(composited).filter(lost).count()
    };
    for range in [AS_PRINTED, OPEN_BELOW] {
        let amendments = [Loop::A.without("CX05"), vec![range]].concat();
        let run = emulate(Loop::A, &pixels, &amendments);
        assert_eq!(without_s_n(&run), 1024);
    }
    // Closed below it is there, even if the range is closed above as well, which CX05 makes half open.
    let closed = emulate(Loop::A, &pixels, &Loop::A.without("CX05"));
    assert_eq!(without_s_n(&closed), 0);
}

#[test]
pub(crate) fn cx08_surfaces_on_the_opaque_surface_are_composited_for_ever() {
    let pixels: Vec<Pixel> = random_image(8)
        .into_iter()
        .map(|pixel| {
            let opaque = pixel[3].fragment.depth;
            before(pixel, opaque)
        })
        .collect();
    for which in [Loop::A, Loop::B] {
        let endless = without(which, "CX08", &pixels);
        assert_eq!(endless.bad(&pixels), 1024, "{which:?}");
        assert!(!endless.ended(), "{which:?}");
    }
}

#[test]
pub(crate) fn cx09_surfaces_on_the_near_plane_are_lost() {
    let pixels: Vec<Pixel> = tied_image(8, 5)
        .into_iter()
        .map(|mut pixel| {
            let nearest = depth_of(0, 5);
            for surface in &mut pixel {
                surface.fragment.depth -= nearest;
            }
            pixel
        })
        .collect();
    let near = pixels
        .iter()
        .filter(|p| p.iter().any(|s| s.fragment.depth == 0.0))
        .count();
    for which in [Loop::A, Loop::B] {
        amended(which, &pixels);
        // CX11's cure reads the same range, and would find for pass 6 what pass 1 has not seen.
        let mut open = which.without("CX09");
        open.retain(|amendment| amendment.key != "CX11");
        assert_eq!(
            emulate(which, &pixels, &open).bad(&pixels),
            near,
            "{which:?}"
        );
    }
    assert!(near > 800);
}

#[test]
pub(crate) fn cx10_counting_pass_5_alone_ends_the_loop_too_early() {
    const PASS_5_ONLY: Amendment = Amendment {
        key: "CX10",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "section 5.2, the query",
        printed: steps! { run coherent::PASS_6; glEndQuery(onionskin::low_level::papers::carr_2008::COMPOSITED); },
        amended: steps! { glEndQuery(onionskin::low_level::papers::carr_2008::COMPOSITED); run coherent::PASS_6; },
        why: "'occlusion queries during the compositing phase', read as pass 5",
        test: "this one",
    };
    // Where s_n has a tie the run is empty: pass 6 alone composites it. With many pixels some run is never empty, so
    // this shows on single pixels.
    let wrong = |amendments: &[Amendment]| {
        let images = tied_image(8, 4);
        let wrong = |pixels: &&[Pixel]| emulate(Loop::A, pixels, amendments).bad(pixels) > 0;
        images.chunks(1).take(400).filter(wrong).count()
    };
    let both_passes = Loop::A.without("CX08");
    assert_eq!(wrong(&both_passes), 0);
    let pass_5_only = wrong(&[&[PASS_5_ONLY], &both_passes[..]].concat());
    assert_eq!(pass_5_only, 337);
}

#[test]
pub(crate) fn cx11_a_closed_range_in_pass_2_only_costs_iterations() {
    let pixels: Vec<Pixel> = random_image(8)
        .into_iter()
        .map(|pixel| {
            let opaque = pixel[3].fragment.depth;
            before(pixel, opaque)
        })
        .collect();
    let right = amended(Loop::A, &pixels).iterations();
    let closed = without(Loop::A, "CX11", &pixels);
    assert_eq!(closed.bad(&pixels), 0);
    assert_eq!((closed.iterations(), right), (6, 5));
}

#[test]
pub(crate) fn cx12_state_left_behind_loses_surfaces() {
    let pixels = random_image(8);
    for which in [Loop::A, Loop::B] {
        let lost = without(which, "CX12", &pixels);
        assert!(lost.bad(&pixels) > 1000, "{which:?}: {}", lost.bad(&pixels));
    }
}

#[test]
pub(crate) fn cx13_white_clears_erase_the_image() {
    let pixels = random_image(8);
    let wrong = |run: &Emulated| {
        let colors = run.emulator.colors(peels::IMAGE).unwrap();
        let off = |(pixel, color): &(&Pixel, &[f32; 4])| {
            let expected = expected_color(pixel);
            (0..4).any(|channel| (f64::from(color[channel]) - expected[channel]).abs() > 0.01)
        };
        pixels.iter().zip(colors).filter(off).count()
    };
    assert_eq!(wrong(&amended(Loop::A, &pixels)), 0);
    assert_eq!(wrong(&without(Loop::A, "CX13", &pixels)), 1024);
}

#[test]
pub(crate) fn cx16_the_printed_blend_factors_multiply_all_earlier_depths() {
    // Two surfaces that lower the depth are right by chance, since the color was cleared to 1.
    let blank = reversed(16);
    let printed = without(Loop::B, "CX16", &blank);
    assert!(printed.emulator.composited()[0].len() < 16);
    let pixels = random_image(8);
    let printed = without(Loop::B, "CX16", &pixels);
    assert_eq!(printed.bad(&pixels), 734);
    assert_eq!(without(Loop::B, "CX16", &reversed(2)).bad(&reversed(2)), 0);
}

#[test]
pub(crate) fn cx17_sixteen_bit_floats_are_not_enough_for_depths() {
    // z_min_prev rounds, and may come to lie before D(sn).
    let mut chance = Chance::new(17);
    let pixels: Vec<Pixel> = (0..1024)
        .map(|_| pixel((0..16).map(|_| chance.below(1 << 20) as f32 / (1 << 20) as f32)))
        .collect();
    let run = |color| {
        let amendments = Loop::B.amendments();
        emulate_in(
            Loop::B,
            &pixels,
            &amendments,
            color,
            Format::Depth32FStencil8,
        )
    };
    let (half, full) = (run(Format::Rgba16F), run(Format::Rgba32F));
    assert_eq!(full.bad(&pixels), 0);
    assert_eq!((half.bad(&pixels), half.iterations()), (2, 16));
    assert_eq!(full.iterations(), 9);
}

#[test]
pub(crate) fn cx14_blending_left_on_does_no_harm_where_maps_are_depths() {
    // If maps were read from colors, it would. Here they are copies of the depth buffer, and colors are masked.
    const OFF: Amendment = Amendment {
        amended: steps! {
            glBindFramebuffer(onionskin::low_level::papers::stage::PEEL);
            glDisable(onionskin::low_level::steps::gl::BLEND);
            glColorMask(false, false, false, false);
        },
        ..CLEAN_STATE
    };
    // Where the passes draw colors, it shows whether blending is on, until the next white clear.
    const OFF_UNMASKED: Amendment = changed(
        CLEAN_STATE.printed,
        steps! {
            glBindFramebuffer(onionskin::low_level::papers::stage::PEEL);
            glDisable(onionskin::low_level::steps::gl::BLEND);
        },
    );
    let pixels = random_image(8);
    for which in [Loop::A, Loop::B] {
        let image = |amendments: &[Amendment], iterations| {
            let mut emulator = Emulator::new(pixels.clone());
            which.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
            which.run(&mut emulator, amendments, iterations);
            emulator.colors(peels::IMAGE).unwrap().to_vec()
        };
        let others = which.without("CX13");
        let with = |amendment| [&[amendment], &others[..]].concat();
        assert!(
            image(&with(OFF), 10.0) == image(&which.amendments(), 10.0),
            "{which:?}"
        );
        assert!(
            image(&with(OFF_UNMASKED), 2.0) != image(&others, 2.0),
            "{which:?}"
        );
    }
}

#[test]
pub(crate) fn cx18_two_calls_of_section_6_do_nothing() {
    // Whatever the clear value: the next clear of the stencil is pass 3's, which sets its own.
    const STENCIL: Amendment = changed(
        steps! { glClearStencil(0); glClearDepth(1.0); glClearColor(1.0, 1.0, 1.0, 1.0); },
        steps! { glClearStencil(7); glClearDepth(1.0); glClearColor(1.0, 1.0, 1.0, 1.0); },
    );
    const ONE_CLEAR: Amendment = changed(
        steps! { glClear(DEPTH_BUFFER_BIT); glClear(COLOR_AND_DEPTH_BUFFER_BITS); },
        steps! { glClear(COLOR_AND_DEPTH_BUFFER_BITS); },
    );
    const THE_OTHER: Amendment = changed(ONE_CLEAR.printed, steps! { glClear(DEPTH_BUFFER_BIT); });
    const NO_CLEAR_VALUE: Amendment = changed(
        STENCIL.printed,
        steps! { glClearStencil(0); glClearDepth(1.0); },
    );
    let pixels = random_image(8);
    let run = |more: &[Amendment]| {
        let run = emulate(Loop::B, &pixels, &[more, &Loop::B.amendments()].concat());
        (
            run.emulator.composited().to_vec(),
            run.iterations(),
            run.ended(),
        )
    };
    let right = run(&[]);
    for idle in [STENCIL, ONE_CLEAR] {
        assert_eq!(run(&[idle]), right);
    }
    for needed in [THE_OTHER, NO_CLEAR_VALUE] {
        assert_ne!(run(&[needed]), right);
    }
}

/// Half of the surfaces are sorted geometry.
fn half_sorted(pixels: Vec<Pixel>) -> Vec<Pixel> {
    pixels
        .into_iter()
        .map(|mut pixel| {
            let middle = pixel.len() / 2;
            let mut depths: Vec<f32> = pixel[middle..].iter().map(|s| s.fragment.depth).collect();
            depths.sort_by(f32::total_cmp);
            for (surface, depth) in pixel[middle..].iter_mut().zip(depths) {
                surface.fragment.depth = depth;
                surface.group = onionskin::low_level::emulator::Group::Sorted;
            }
            pixel
        })
        .collect()
}

/// Wrong pixels of the listing and of the pseudocode without an amendment; with all of them there are none.
fn hybrid_without(key: &str, pixels: &[Pixel]) -> [usize; 2] {
    amended(Loop::Hybrid, pixels);
    let rest: Vec<_> = hybrid::AMENDMENTS_1
        .iter()
        .copied()
        .filter(|a| a.key != key)
        .collect();
    assert!(rest.len() < hybrid::AMENDMENTS_1.len());
    let limit = pixels.iter().map(Vec::len).max().unwrap() as u32 + 2;
    let right = run_algorithm(&hybrid::ALGORITHM_1, &hybrid::AMENDMENTS_1, pixels, limit).unwrap();
    assert_eq!(bad(pixels, &right.composited), 0);
    let wrong = run_algorithm(&hybrid::ALGORITHM_1, &rest, pixels, limit).unwrap();
    let listing = emulate(Loop::Hybrid, pixels, &Loop::Hybrid.without(key));
    [listing.bad(pixels), bad(pixels, &wrong.composited)]
}

#[test]
pub(crate) fn cx19_sorted_surfaces_at_a_peel_depth_are_lost() {
    let pixels = half_sorted(tied_image(20, 64));
    assert_eq!(hybrid_without("CX19", &pixels), [812; 2]);
}

#[test]
pub(crate) fn cx20_unsorted_surfaces_on_the_opaque_surface_are_composited_in_every_iteration() {
    let mut chance = Chance::new(20);
    let pixels: Vec<Pixel> = half_sorted(random_image(12))
        .into_iter()
        .map(|pixel| {
            let opaque = pixel[chance.below(6)].fragment.depth;
            before(pixel, opaque)
        })
        .collect();
    assert_eq!(hybrid_without("CX20", &pixels), [840; 2]);
}

#[test]
pub(crate) fn cx21_unsorted_surfaces_on_the_near_plane_are_lost() {
    let pixels: Vec<Pixel> = half_sorted(tied_image(8, 16))
        .into_iter()
        .map(|mut pixel| {
            for surface in &mut pixel {
                surface.fragment.depth -= depth_of(0, 16);
            }
            pixel
        })
        .collect();
    let [listing, pseudocode] = hybrid_without("CX21", &pixels);
    assert!(
        listing > 100 && listing == pseudocode,
        "{listing} {pseudocode}"
    );
}

#[test]
pub(crate) fn c02_iterations_depend_on_the_unsorted_geometry_only() {
    for slices in [0, 10, 100] {
        let mut surfaces = pixel([0.8, 0.2, 0.5]);
        let sorted = pixel((0..slices).map(|k| depth_of(k, slices)));
        for mut surface in sorted {
            surface.group = onionskin::low_level::emulator::Group::Sorted;
            surface.fragment.order += 3;
            surfaces.push(surface);
        }
        assert_eq!(amended(Loop::Hybrid, &[surfaces]).iterations(), 4);
    }
}

#[test]
pub(crate) fn cx22_pixels_that_are_done_composite_their_last_layer_again() {
    let pixels = random_image(8);
    let printed = algorithm_2(&[], &pixels);
    assert_eq!(bad(&pixels, &printed.composited), 1020);
    assert_eq!(
        bad(
            &pixels,
            &algorithm_2(&ideal::AMENDMENTS_2, &pixels).composited
        ),
        0
    );
    // A single pixel does not show it: the loop ends with it. Nor do pixels that end together.
    for pixel in pixels.chunks(1).take(100) {
        assert_eq!(bad(pixel, &algorithm_2(&[], pixel).composited), 0);
    }
}

#[test]
pub(crate) fn cx23_the_tighter_bound_halves_reversed_input() {
    for (pixels, name) in [(reversed(16), "reversed 16"), (random_image(8), "random 8")] {
        let printed = algorithm_2(&ideal::AMENDMENTS_2, &pixels);
        let tight = algorithm_2(&ideal::TIGHT_BOUND, &pixels);
        assert_eq!(bad(&pixels, &tight.composited), 0, "{name}");
        println!(
            "{name}: {} to {} iterations",
            printed.iterations, tight.iterations
        );
        assert!(tight.iterations < printed.iterations, "{name}");
    }
    assert_eq!(
        algorithm_2(&ideal::AMENDMENTS_2, &reversed(16)).iterations,
        17
    );
    assert_eq!(
        algorithm_2(&ideal::TIGHT_BOUND, &reversed(16)).iterations,
        9
    );
}

// ---- Depth formats ---------------------------------------------------------------------------------------------------

#[test]
fn depths_of_24_bits_are_a_trap_when_they_are_sampled() {
    // The shader compares a fragment's own depth, which is not rounded, with one that was stored and sampled, which is;
    // and llvmpipe does not even sample what it stored. The text asks for "full precision buffers" in section 7 only.
    let pixels = random_image(8);
    for which in [Loop::A, Loop::B, Loop::LayerPeeling] {
        let amendments = which.amendments();
        let run = |depth| emulate_in(which, &pixels, &amendments, Format::Rgba32F, depth);
        let (fixed, float) = (run(Format::Depth24Stencil8), run(Format::Depth32FStencil8));
        println!(
            "{which:?}: {} of 1024 pixels wrong on 24 bits",
            fixed.bad(&pixels)
        );
        assert!(fixed.bad(&pixels) > 400, "{which:?}");
        assert_eq!(float.bad(&pixels), 0, "{which:?}");
    }
}
