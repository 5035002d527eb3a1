//! The claims of Lindholm et al. 2015 about ppAO, L10 and L11, each under its key, and what happens when it is run as printed.

use crate::kit::a_buffer::*;
use crate::kit::bounds::F32;
use crate::kit::driver::keeps_lists_in_order;
use crate::kit::stack::row;
use onionskin::low_level::papers::lindholm_2015::BY_COUNTER;
use onionskin::low_level::steps::{Amendment, Shader};
use onionskin::options::{ABufferOptions, Fill, Manager, Reading};
use onionskin::{Comparison, Context, CountBy, Method, Renderer, steps};

/// "The counting can be combined with the scene rasterization in the Fill Step and, hence, no additional rendering passes
/// are required." That holds of a buffer whose size does not depend on the counts: one geometry pass counts, fills, and
/// tells segments apart, as printed (by the stencil buffer) and as amended (by the fill's own counter).
#[test]
pub(crate) fn l10_the_fill_counts_and_no_geometry_pass_is_added() {
    let context = Context::headless().unwrap();
    let scene = bundled("soup.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let deepest = renderer.complexity(&scene, CountBy::Blending).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap().image;
    for (pp_ao, reading) in [
        (false, Reading::Amended),
        (true, Reading::Amended),
        (true, Reading::AsPrinted),
    ] {
        for fill in [Fill::Atomics, Fill::Automatic] {
            let options = ABufferOptions {
                manager: Manager::Ffb,
                fixed_layers: Some(deepest.max()),
                pp_ao,
                reading,
                fill,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &scene, options);
            let passes = (frame.stats.geometry_passes, cost.counting_passes);
            assert_eq!(passes, (1, 0), "{options:?}");
            assert_eq!(frame.stats.lost, Some(0));
            let error = Comparison::new(&frame.image, &exact, F32).unwrap();
            assert_eq!(error.over, 0, "{options:?}: {error:?}");
            if pp_ao {
                assert_eq!(
                    cost.resolved,
                    deepest.covered(),
                    "each pixel in one segment"
                );
                assert!(cost.slots_reserved * 4 < deepest.covered() * 64);
            }
        }
    }
}

/// A buffer that is as large as the counts say needs them before it is filled. That pass is the manager's: it is there
/// with a static array, too.
#[test]
pub(crate) fn l10_the_counting_pass_is_the_memory_manager_s_and_not_pp_ao_s() {
    let context = Context::headless().unwrap();
    let scene = bundled("soup.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    for manager in MANAGERS {
        for (pp_ao, reading) in [
            (false, Reading::Amended),
            (true, Reading::Amended),
            (true, Reading::AsPrinted),
        ] {
            let options = ABufferOptions {
                manager,
                pp_ao,
                reading,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &scene, options);
            assert_eq!(cost.counting_passes, 1, "{options:?}");
            // And one to fill each band.
            let fills = u64::from(cost.bands);
            assert_eq!(frame.stats.geometry_passes, 1 + fills, "{options:?}");
        }
    }
}

/// What a fixed buffer has no room for is lost, and counted: of each list what came last.
#[test]
pub(crate) fn l10_what_a_fixed_buffer_has_no_room_for_is_lost_and_counted() {
    let context = Context::headless().unwrap();
    if !keeps_lists_in_order(&context) {
        return;
    }
    let counts = [3, 8, 9, 20, 64, 100];
    let stack = row(&counts);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    for (layers, pp_dp) in [(8, false), (20, true), (100, true)] {
        for pp_ao in [false, true] {
            let options = ABufferOptions {
                manager: Manager::Ffb,
                fixed_layers: Some(layers),
                pp_ao,
                pp_dp,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &stack.scene(), options);
            let past = |&count: &usize| count.saturating_sub(layers as usize);
            let lost: usize = counts.iter().map(past).sum();
            assert_eq!(frame.stats.lost, Some(lost as u64), "{options:?}");
            assert_eq!(cost.list_bytes, 6 * 32 * u64::from(layers));
            let mut kept = stack.clone();
            kept.pixels
                .iter_mut()
                .for_each(|list| list.truncate(layers as usize));
            let error = Comparison::new(&frame.image, &kept.expected(), F32).unwrap();
            assert_eq!(error.over, 0, "{options:?}: {error:?}");
            let why = if lost > 0 {
                "fixed buffer full"
            } else {
                "done"
            };
            assert_eq!(frame.stats.stopped_text(), why);
        }
    }
}

/// Each pixel's array is the smallest of 8, 16, 32 and 64 that holds its fragments.
#[test]
pub(crate) fn l10_every_pixel_is_resolved_by_the_smallest_segment_that_holds_it() {
    let context = Context::headless().unwrap();
    for complexity in [1, 7, 8, 9, 16, 17, 32, 33, 64] {
        let mut renderer = Renderer::new(&context, 2, 1).unwrap();
        let options = ABufferOptions {
            pp_ao: true,
            ..options()
        };
        let (_, cost) = render(&mut renderer, &row(&[complexity; 2]).scene(), options);
        let smallest = [8, 16, 32, 64]
            .into_iter()
            .find(|&n| n >= complexity)
            .unwrap();
        assert_eq!(cost.slots_reserved, 2 * smallest as u64, "{complexity}");
    }
}

/// 255 and more in one segment, none lost, by the amended counter and ppDP.
#[test]
pub(crate) fn l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost() {
    let context = Context::headless().unwrap();
    let stack = row(&[254, 255, 256, 257, 300, 600]);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    let options = ABufferOptions {
        pp_ao: true,
        pp_dp: true,
        ..options()
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), options);
    assert_eq!((frame.stats.lost, cost.resolved), (Some(0), 6));
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

/// "Using an 8bit buffer does not limit the depth complexity to 255. Higher complexities ... will all be associated with
/// the same segment": eight bits and INCR, as printed. It holds if the last segment is one of 256, whose reference OpenGL
/// clamps to 255. What is past 256 is lost without ppDP.
#[test]
pub(crate) fn l11_eight_bits_leave_255_and_more_to_the_last_segment_as_printed() {
    let context = Context::headless().unwrap();
    if !keeps_lists_in_order(&context) {
        return;
    }
    let counts = [254, 255, 256, 257, 280];
    let stack = row(&counts);
    let mut renderer = Renderer::new(&context, 5, 1).unwrap();
    let options = ABufferOptions {
        pp_ao: true,
        array: 256,
        reading: Reading::AsPrinted,
        ..options()
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), options);
    // Each once, none in a smaller segment.
    assert_eq!(cost.resolved, 5);
    assert_eq!(cost.slots_reserved, 5 * 256);
    assert_eq!(frame.stats.lost, Some(1 + 24));
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!(error.over, 2, "{error:?}");
}

/// Erratum LX05: `depth complexity(p) <= i` holds in no segment.
#[test]
pub(crate) fn l11_as_printed_the_stencil_loses_what_lies_past_the_last_segment() {
    let context = Context::headless().unwrap();
    let stack = row(&[64, 65, 100, 300]);
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    for pp_dp in [false, true] {
        let options = ABufferOptions {
            pp_ao: true,
            pp_dp,
            reading: Reading::AsPrinted,
            ..options()
        };
        let (frame, _) = render(&mut renderer, &stack.scene(), options);
        assert_eq!(frame.stats.lost, Some(65 + 100 + 300));
    }
}

/// Erratum LX05 alone: by the integer counter of LX06 each pixel is in one segment or, past the last, in none.
#[test]
pub(crate) fn lx05_by_counter_alone_exactly_what_lies_past_the_last_segment_is_lost() {
    const BY_COUNTER_ALONE: &[Amendment] = &[Amendment {
        amended: steps! { glUseProgramOfSize(Shader("a_buffer/resolve_segment"), "i"); },
        ..BY_COUNTER
    }];
    let context = Context::headless().unwrap();
    let stack = row(&[64, 65, 127, 128, 255, 256, 300]);
    let mut renderer = Renderer::new(&context, 7, 1).unwrap();
    // Of the amended ones a static array of the last segment's size holds what it can.
    for (array, pp_dp, [resolved, lost], lost_amended) in [
        (64, false, [1, 1131], 747),
        (64, true, [1, 1131], 0),
        (256, false, [6, 300], 44),
    ] {
        let amended = ABufferOptions {
            pp_ao: true,
            pp_dp,
            array,
            ..options()
        };
        let alone = ABufferOptions {
            amendments: BY_COUNTER_ALONE,
            ..amended
        };
        let mut counts = |options| {
            let (frame, cost) = render(&mut renderer, &stack.scene(), options);
            (cost.resolved, frame.stats.lost)
        };
        assert_eq!(counts(alone), (resolved, Some(lost)), "{array}");
        assert_eq!(counts(amended), (7, Some(lost_amended)), "{array}");
    }
}

/// Errata LX06 and LX07 on the driver's own stencil buffer: INVERT puts a complexity of 127 to 128, which is another segment's.
#[test]
pub(crate) fn lx07_as_printed_pixels_are_resolved_twice() {
    let context = Context::headless().unwrap();
    let counts = [100, 126, 127, 128];
    let stack = row(&counts);
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let printed = ABufferOptions {
        pp_ao: true,
        array: 256,
        reading: Reading::AsPrinted,
        ..options()
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), printed);
    // 256 is clamped to 255, so that its segment takes 127 and 128 twice; 128 is resolved in it for the first time.
    assert!(cost.resolved > 4, "{}", cost.resolved);
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert!(error.over > 0, "blended twice: {error:?}");
    let amended = ABufferOptions {
        reading: Reading::Amended,
        ..printed
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), amended);
    assert_eq!(cost.resolved, 4);
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

/// Erratum LX16: the stencil buffer is there, and nothing counts into it. As printed, the fill does.
#[test]
pub(crate) fn lx16_literally_the_stencil_buffer_holds_no_count_and_masks_nothing() {
    let context = Context::headless().unwrap();
    let counts = [1, 5, 20, 60];
    let stack = row(&counts);
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    for manager in MANAGERS {
        let mut cost = |reading| {
            let options = ABufferOptions {
                manager,
                pp_ao: true,
                reading,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &stack.scene(), options);
            let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            (cost.resolved, cost.slots_reserved, error.over)
        };
        // Each of four segments draws each of four pixels, and the last one's cost is what is left. A pixel of one fragment is
        // seen four times over itself.
        assert_eq!(cost(Reading::Literal), (16, 4 * 64, 4));
        assert_eq!(cost(Reading::AsPrinted), (4, 8 + 8 + 32 + 64, 0));
    }
}
