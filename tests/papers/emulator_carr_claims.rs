//! What Carr et al. (2008) claim of iterations, overflows and orders, counted on emulated pixels, and what the
//! improvements buy that they only point at.

use crate::kit::changed::changed;
use crate::kit::peels;
use approx::assert_abs_diff_eq;
use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::papers::carr_2008::coherent::{
    STOP_ON_PASS_1, STOP_ON_SECTION_6, TIE_FRIENDLY,
};
use onionskin::low_level::papers::carr_2008::ideal;
use onionskin::low_level::steps::{Amendment, Call, Machine, Reason, gl::*};
use onionskin::{Format, steps};

use crate::kit::peels::{
    Emulated, LOOPS, Loop, Pixel, algorithm_2, amended, bad, before, depth_of, emulate,
    expected_color, nearly_sorted_image, opaque_depth, pixel, random_image, reversed, sorted,
    tied_image,
};

#[test]
pub(crate) fn c12_sorted_input_takes_one_iteration_and_one_that_finds_nothing() {
    for which in [Loop::A, Loop::B] {
        for n in [1, 2, 30, 127, 128] {
            assert_eq!(amended(which, &sorted(n)).iterations(), 2, "{which:?} {n}");
        }
    }
}

#[test]
pub(crate) fn c13_reversed_input_takes_half_as_many_iterations_as_it_has_layers() {
    for which in [Loop::A, Loop::B] {
        for n in [1, 2, 3, 9, 16, 32] {
            let iterations = amended(which, &reversed(n)).iterations() as usize;
            assert_eq!(iterations, n.div_ceil(2) + 1, "{which:?} {n}");
        }
    }
    assert_eq!(amended(Loop::LayerPeeling, &reversed(32)).iterations(), 33);
}

#[test]
pub(crate) fn c13_at_least_two_layers_leave_per_iteration() {
    for n in [8, 24] {
        for pixel in random_image(n).chunks(1) {
            let useful = amended(Loop::A, pixel).iterations() - 1;
            assert!(useful as usize <= n.div_ceil(2));
        }
    }
}

#[test]
pub(crate) fn c14_an_overflow_of_pass_1_costs_iterations_but_loses_nothing() {
    // The text: "the stencil count will be invalid". INCR saturates; any z_min_prev at or behind the right one is safe.
    for n in [255, 256, 257, 300, 600] {
        let a = amended(Loop::A, &reversed(n)).iterations();
        let b = amended(Loop::B, &reversed(n)).iterations();
        assert_eq!(b as usize, n.div_ceil(2) + 1, "{n}");
        // Each layer past 255 costs an iteration more, where two layers cost one.
        let expected = if n <= 255 { b as usize } else { n - 126 };
        assert_eq!(a as usize, expected, "{n}");
    }
}

#[test]
pub(crate) fn c14_wrapping_instead_of_saturating_loses_nothing_either() {
    const WRAP: Amendment = Amendment {
        key: "wrap",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "pass 1",
        printed: steps! { glStencilOp(KEEP, KEEP, INCR); },
        amended: steps! { glStencilOp(KEEP, KEEP, INCR_WRAP); },
        why: "another reading of 'overflow'",
        test: "this one",
    };
    let mut amendments = Loop::A.amendments();
    amendments.push(WRAP);
    let pixels = reversed(300);
    let emulated = emulate(Loop::A, &pixels, &amendments);
    assert!(emulated.ended());
    assert_eq!(emulated.bad(&pixels), 0);
}

#[test]
pub(crate) fn c15_an_iteration_peels_at_most_128_surfaces_and_loses_none() {
    for (n, useful) in [
        (127, 1),
        (128, 1),
        (129, 2),
        (255, 2),
        (256, 2),
        (257, 3),
        (600, 5),
    ] {
        for which in [Loop::A, Loop::B] {
            let iterations = amended(which, &sorted(n)).iterations();
            assert_eq!(iterations, useful + 1, "{which:?} {n}");
        }
    }
}

/// "This process is repeated until no surfaces remain to be peeled. We can detect when this occurs using occlusion queries
/// during the compositing phase": every iteration but the last composites something.
#[test]
pub(crate) fn c16_the_loop_stops_when_the_compositing_phase_draws_nothing() {
    const NO_STOP: Amendment = changed(
        steps! { stop if (found == 0) because EmptyLayer; },
        steps! {},
    );
    for pixels in [random_image(8), tied_image(8, 4), reversed(9), sorted(30)] {
        for which in [Loop::A, Loop::B] {
            let iterations = amended(which, &pixels).iterations();
            let up_to = |limit: u32, amendments: &[Amendment]| {
                let mut emulator = Emulator::new(pixels.clone());
                which.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
                let outcome = which.run(&mut emulator, amendments, f64::from(limit));
                let composited = outcome.variables.get("composited").unwrap();
                (composited, outcome.stopped)
            };
            let mut before = 0.0;
            for limit in 1..iterations {
                let (composited, stopped) = up_to(limit, &which.amendments());
                assert!(
                    composited > before && stopped.is_none(),
                    "{which:?} {limit}"
                );
                before = composited;
            }
            let last = up_to(iterations, &which.amendments());
            assert_eq!(last, (before, Some(Reason::EmptyLayer)), "{which:?}");
            // Without it the loop goes on, and finds nothing again and again.
            let mut endless = which.amendments();
            endless.push(NO_STOP);
            assert_eq!(up_to(iterations + 5, &endless), (before, None), "{which:?}");
        }
    }
}

#[test]
pub(crate) fn c24_sorting_beforehand_removes_the_overflow() {
    let n = 600;
    let mut pixels = reversed(n);
    let unsorted = amended(Loop::A, &pixels).iterations();
    pixels[0].sort_by(|a, b| a.fragment.depth.total_cmp(&b.fragment.depth));
    let sorted = amended(Loop::A, &pixels).iterations();
    assert!(sorted < 10 && unsorted > 400, "{unsorted} to {sorted}");
}

#[test]
pub(crate) fn c19_the_ideal_gpu_takes_at_most_as_many_iterations_as_layer_peeling() {
    for n in [1, 8, 16, 24] {
        for pixels in [
            random_image(n),
            reversed(n),
            sorted(n),
            nearly_sorted_image(n),
        ] {
            let layers = amended(Loop::LayerPeeling, &pixels).iterations();
            let ideal = algorithm_2(&ideal::AMENDMENTS_2, &pixels);
            assert_eq!(bad(&pixels, &ideal.composited), 0);
            assert!(
                ideal.iterations <= layers,
                "{n}: {} and {layers}",
                ideal.iterations
            );
            // Two passes each, and one that finds nothing.
            assert_eq!(ideal.geometry_passes, 2 * ideal.iterations - 1);
        }
    }
}

#[test]
fn the_image_is_the_oracle_s() {
    for which in LOOPS {
        let pixels: Vec<Pixel> = random_image(12)
            .into_iter()
            .enumerate()
            .map(|(i, pixel)| match i % 3 {
                0 => before(pixel, 0.4),
                _ => pixel,
            })
            .collect();
        let emulated = emulate(which, &pixels, &which.amendments());
        let image = emulated.emulator.colors(peels::IMAGE).unwrap();
        for (pixel, color) in pixels.iter().zip(image) {
            let expected = expected_color(pixel);
            for (channel, is) in color.iter().enumerate() {
                // 13 surfaces, three roundings of 2^-24 each, of numbers of at most 1: 2.4e-6.
                assert_abs_diff_eq!(f64::from(*is), expected[channel], epsilon = 3e-6);
            }
        }
    }
}

fn improved(which: Loop, pixels: &[Pixel], improvement: Amendment) -> Emulated {
    let mut amendments = vec![improvement];
    amendments.extend(which.amendments());
    let emulated = emulate(which, pixels, &amendments);
    assert!(emulated.ended());
    assert_eq!(emulated.bad(pixels), 0, "{}", improvement.key);
    emulated
}

#[test]
pub(crate) fn tie_friendly_pass_3_peels_sorted_pairs_at_once() {
    let pairs = vec![pixel((0..32).map(|k| depth_of(k / 2, 16)))];
    assert_eq!(amended(Loop::A, &pairs).iterations(), 17);
    assert_eq!(improved(Loop::A, &pairs, TIE_FRIENDLY).iterations(), 2);
    for pixels in [tied_image(8, 4), tied_image(8, 8), random_image(8)] {
        for which in [Loop::A, Loop::B] {
            let faithful = amended(which, &pixels).iterations();
            assert!(improved(which, &pixels, TIE_FRIENDLY).iterations() <= faithful);
        }
    }
}

#[test]
pub(crate) fn a_query_on_pass_1_ends_a_sorted_scene_after_seven_passes() {
    let passes = |emulated: &Emulated| emulated.emulator.record().draws.len();
    for (which, improvement, faithful, early) in [
        (Loop::A, STOP_ON_PASS_1, 12, 7),
        (Loop::B, STOP_ON_SECTION_6, 10, 6),
    ] {
        let run = |amendments: &[Amendment]| {
            let mut emulator = Emulator::new(sorted(30)).watching(0);
            which.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
            let outcome = which.run(&mut emulator, amendments, 10.0);
            assert_eq!(outcome.stopped, Some(Reason::EmptyLayer));
            Emulated { emulator, outcome }
        };
        let mut amendments = vec![improvement];
        amendments.extend(which.amendments());
        // OPAQUE_FIRST draws once more, opaque objects.
        assert_eq!(passes(&run(&which.amendments())) - 1, faithful);
        assert_eq!(passes(&run(&amendments)) - 1, early);
    }
    for pixels in [random_image(8), tied_image(8, 4)] {
        improved(Loop::A, &pixels, STOP_ON_PASS_1);
        improved(Loop::B, &pixels, STOP_ON_SECTION_6);
    }
}

#[test]
pub(crate) fn pass_2_is_only_an_accelerator() {
    // Any z_min_prev at or behind the right one is safe: passes 3 and 4 find what it misses as the run's end.
    const SKIPPED: Amendment = Amendment {
        key: "skipped",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "section 5.1, pass 2",
        printed: steps! { run steps_of_pass_2::PASS_2; },
        amended: steps! { glClearDepth(1.0); glClear(DEPTH_BUFFER_BIT); },
        why: "what is pass 2 good for?",
        test: "this one",
    };
    use onionskin::low_level::papers::carr_2008::passes as steps_of_pass_2;
    let pixels = random_image(8);
    let mut amendments = vec![SKIPPED];
    amendments.extend(Loop::A.amendments());
    let skipped = emulate(Loop::A, &pixels, &amendments);
    assert_eq!(skipped.bad(&pixels), 0);
    assert!(skipped.iterations() > amended(Loop::A, &pixels).iterations());
}

#[test]
pub(crate) fn c22_nothing_behind_the_opaque_depth_is_composited_or_counted() {
    for which in LOOPS {
        let pixels: Vec<Pixel> = random_image(16)
            .into_iter()
            .map(|p| before(p, 0.5))
            .collect();
        let emulated = amended(which, &pixels);
        let shallow = pixels.iter().map(|p| {
            p.iter()
                .filter(|s| s.fragment.depth < opaque_depth(p))
                .count()
        });
        let total: usize = shallow.sum();
        assert_eq!(
            emulated.outcome.variables.get("composited"),
            Some(total as f64)
        );
    }
}

#[test]
fn a_call_that_the_emulated_pixel_cannot_perform_is_named() {
    let mut emulator = Emulator::new(vec![pixel([0.5])]);
    let error = emulator
        .perform(&Call::ActiveDepthUnit { unit: 0 })
        .unwrap_err();
    assert!(
        error.to_string().contains("activeDepthUnit(unit = 0)"),
        "{error}"
    );
    let unknown = Call::UseProgram {
        program: onionskin::low_level::steps::Shader("capture"),
    };
    let error = emulator.perform(&unknown).unwrap_err().to_string();
    assert!(error.contains("no twin of the shader 'capture'"), "{error}");
}
