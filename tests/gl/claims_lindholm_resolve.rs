//! The claims of Lindholm et al. 2015 about the Resolve Step, L09, L12 to L15 and L18, each under its key, and what happens
//! when ppDP is run as printed.

use crate::kit::bounds::F32;
use onionskin::generate::SubmissionOrder;
use onionskin::options::{ABufferOptions, Reading};
use onionskin::{Comparison, Context, CountBy, Method, Renderer};

use crate::kit::a_buffer::*;
use crate::kit::pp_dp::{Rule, peel};
use crate::kit::stack::{Stack, row, scattered};

#[test]
pub(crate) fn l09_a_static_array_loses_everything_past_n_and_says_so() {
    let context = Context::headless().unwrap();
    let counts = [3, 8, 9, 20, 64, 100];
    let stack = row(&counts);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    for manager in MANAGERS {
        for array in [8, 64] {
            let options = ABufferOptions {
                manager,
                array,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &stack.scene(), options);
            let lost: usize = counts
                .iter()
                .map(|&c| c.saturating_sub(array as usize))
                .sum();
            let pixels = counts.iter().filter(|&&c| c > array as usize).count();
            assert_eq!(frame.stats.lost, Some(lost as u64));
            assert_eq!(cost.truncated_pixels, pixels as u64);
            assert_eq!(frame.stats.stopped_text(), "local array full");
            let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            assert_eq!(error.over, pixels, "the others are right: {error:?}");
        }
    }
}

/// The bound, and that it is not reached: the pseudocode resolves n, not n - 1 (erratum LX02).
#[test]
pub(crate) fn l12_a_pixel_takes_at_most_d_over_n_minus_1_subpasses() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for complexity in [1, 7, 8, 9, 24, 64, 65, 200] {
        for n in [2, 5, 8, 13] {
            let options = ABufferOptions {
                pp_dp: true,
                peel: n,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &row(&[complexity]).scene(), options);
            assert_eq!(frame.stats.lost, Some(0));
            assert!(cost.most_subpasses as usize <= complexity.div_ceil(n as usize - 1));
            assert_eq!(
                cost.most_subpasses as usize,
                complexity.div_ceil(n as usize)
            );
            assert_eq!(
                cost.records_read,
                u64::from(cost.most_subpasses) * complexity as u64
            );
        }
    }
}

/// Errata LX01 and LX04: what the printed rule loses, fragment by fragment, is what a twin in Rust says it must; and the
/// amended rule loses none.
#[test]
pub(crate) fn l13_as_printed_ties_are_lost_where_a_buffer_ends_and_amended_none() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let mut lost_in_all = 0;
    for levels in [1, 3, 12, 64] {
        for complexity in [8, 20, 24] {
            let stack = tied(complexity, levels);
            let scene = stack.scene();
            let printed = ABufferOptions {
                pp_dp: true,
                reading: Reading::AsPrinted,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &scene, printed);
            let mut expected = (0, 0);
            for pieces in &stack.pixels {
                let depths: Vec<u32> = pieces
                    .iter()
                    .map(|piece| u32::from(piece.level) + 1)
                    .collect();
                let twin = peel(&depths, 8, Rule::Printed);
                expected.0 += twin.lost as u64;
                expected.1 += twin.subpasses as u64;
            }
            assert_eq!(frame.stats.lost, Some(expected.0), "{levels} {complexity}");
            assert_eq!(cost.subpasses, expected.1, "{levels} {complexity}");
            lost_in_all += expected.0;

            let amended = ABufferOptions {
                reading: Reading::Amended,
                ..printed
            };
            let (frame, _) = render(&mut renderer, &scene, amended);
            assert_eq!(frame.stats.lost, Some(0));
            let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            assert_eq!(error.over, 0, "{error:?}");
        }
    }
    assert!(
        lost_in_all > 50,
        "{lost_in_all}: there is something to lose"
    );
}

#[test]
pub(crate) fn l14_pp_ao_and_pp_dp_together_give_the_exact_image_too() {
    let context = Context::headless().unwrap();
    let scene = bundled("slices.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap();
    for manager in MANAGERS {
        let both = ABufferOptions {
            manager,
            pp_ao: true,
            pp_dp: true,
            array: 16,
            ..options()
        };
        let (frame, cost) = render(&mut renderer, &scene, both);
        assert_eq!(frame.stats.lost, Some(0));
        let error = Comparison::new(&frame.image, &exact.image, F32).unwrap();
        assert_eq!(error.over, 0, "{error:?}");
        assert!(cost.most_subpasses > 3, "{}", cost.most_subpasses);
    }
}

/// What a ray has not seen when it ends weighs less than the threshold, and no colour is over 1.
#[test]
pub(crate) fn l15_early_ray_termination_errs_by_less_than_its_threshold_and_saves_work() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(64, SubmissionOrder::Shuffled);
    scene.size = [64, 48];
    for vertex in &mut scene.meshes[0].vertices {
        vertex.color.a = 0.3;
    }
    let mut renderer = Renderer::new(&context, 64, 48).unwrap();
    for pp_dp in [false, true] {
        let whole = ABufferOptions { pp_dp, ..options() };
        let (exact, all) = render(&mut renderer, &scene, whole);
        let (ended, some) = render(
            &mut renderer,
            &scene,
            ABufferOptions {
                termination: 0.02,
                ..whole
            },
        );
        let error = Comparison::new(&ended.image, &exact.image, 0.02).unwrap();
        assert!(error.max > 1e-4 && error.over == 0, "{error:?}");
        // 0.7^11 < 0.02: eleven of 64 are composited.
        let pixels = 64 * 48;
        assert_eq!(ended.stats.lost, Some(pixels * (64 - 11)));
        assert_eq!(ended.stats.stopped_text(), "early ray termination");
        if pp_dp {
            assert_eq!((all.most_subpasses, some.most_subpasses), (8, 2));
            assert_eq!(some.records_read * 4, all.records_read);
        }
    }
}

/// Figure 7: 64 screen-filling quads, alpha 0.05, random order in depth: ppAO reserves what the static array does, ppDP
/// reads the lists eight times and needs an eighth of the array.
#[test]
pub(crate) fn l18_sixty_four_quads_cost_what_figure_7_says_they_must() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(64, SubmissionOrder::Shuffled);
    scene.size = [64, 48];
    let mut renderer = Renderer::new(&context, 64, 48).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap();
    let complexity = renderer.complexity(&scene, CountBy::Blending).unwrap();
    let pixels = 64 * 48;
    assert_eq!(complexity.histogram(1)[64].pixels, pixels);
    let mut cost = |pp_ao, pp_dp| {
        let (frame, counts) = render(
            &mut renderer,
            &scene,
            ABufferOptions {
                pp_ao,
                pp_dp,
                ..options()
            },
        );
        let error = Comparison::new(&frame.image, &exact.image, F32).unwrap();
        assert_eq!((error.over, frame.stats.lost), (0, Some(0)), "{error:?}");
        [counts.slots_reserved, counts.records_read, counts.subpasses].map(|n| n / pixels)
    };
    assert_eq!(cost(false, false), [64, 64, 1]);
    assert_eq!(cost(true, false), [64, 64, 1]);
    assert_eq!(cost(false, true), [8, 8 * 64, 8]);
    assert_eq!(cost(true, true), [64, 64, 1]);
}

/// Four pixels with so many fragments on so many levels.
fn tied(count: usize, levels: usize) -> Stack {
    Stack {
        width: 4,
        pixels: (0..4)
            .map(|pixel| scattered(count, pixel * 31, levels))
            .collect(),
        opaque: None,
    }
}
