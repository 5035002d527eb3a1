//! Which fragments a pixel keeps that has more of them than its static array has room for, named one by one: by every
//! memory manager and fill, on OpenGL and on the emulator's lists.

use crate::kit::bounds::F32;
use crate::kit::stack;
use std::cell::RefCell;

use onionskin::low_level::emulator::run_on_lists;
use onionskin::low_level::methods::Technique;
use onionskin::low_level::papers::lindholm_2015::components::{
    KEEP_NEAREST, PP_AO, PP_AO_AMENDMENT, PP_AO_KEEPING_NEAREST, STATIC_ARRAY,
};
use onionskin::options::{ABufferOptions, ArraySort, Fill, Keep, Manager, RecordColor};
use onionskin::{Comparison, Context, Fragment, Image, Method, Renderer, registry};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::a_buffer::{F16, MANAGERS, small};
use crate::kit::fog_scenes::fog_and_pane;
use crate::kit::stack::{Piece, Stack, fragments, runner, scattered, stacks};

/// Twelve fragments, four to a channel, each a fourth as bright as the one before it: bits two places apart.
const COUNT: usize = 12;
const PER_CHANNEL: i32 = 4;
/// So little that what lies in front takes at most 12/16384 from a fragment.
const ALPHA: f32 = 1.0 / 16384.0;
/// The array that they overflow.
const ARRAY: u32 = 8;

/// Levels in the order of submission.
fn orders() -> Vec<(&'static str, [u16; COUNT])> {
    vec![
        (
            "front to back",
            [10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120],
        ),
        (
            "back to front",
            [120, 110, 100, 90, 80, 70, 60, 50, 40, 30, 20, 10],
        ),
        (
            "scattered, with ties",
            [50, 90, 20, 90, 10, 70, 50, 30, 90, 50, 60, 20],
        ),
    ]
}

/// One pixel; the fragment submitted k-th has bit k.
fn with_bits(levels: &[u16; COUNT]) -> Stack {
    let piece = |(k, &level): (i32, &u16)| {
        let mut color = [0.0, 0.0, 0.0, ALPHA];
        color[(k / PER_CHANNEL) as usize] = 0.25_f32.powi(k % PER_CHANNEL);
        Piece { level, color }
    };
    Stack {
        width: 1,
        pixels: vec![(0..).zip(levels).map(piece).collect()],
        opaque: None,
    }
}

/// Whose bits an image over black has. All smaller bits together have at most a third of a bit's light, and what the larger
/// ones lack of theirs is at most 4/3 x 12/16384, a fourteenth of the smallest bit's 1/64: half of a bit's own light lies
/// between having it and not.
fn survivors(image: &Image) -> Vec<u32> {
    let channels = image.pixels[0].to_array();
    let mut found = Vec::new();
    for (channel, mut light) in (0..3).zip(channels) {
        for bit in 0..PER_CHANNEL {
            let own = ALPHA * 0.25_f32.powi(bit);
            if light > own / 2.0 {
                found.push((channel * PER_CHANNEL + bit) as u32);
                light -= own;
            }
        }
    }
    found
}

fn sorted(mut orders: Vec<u32>) -> Vec<u32> {
    orders.sort_unstable();
    orders
}

/// The n nearest of a list, of equal depths the first submitted, by the order of submission.
fn nearest(list: &[Fragment], n: u32) -> Vec<Fragment> {
    let mut list = list.to_vec();
    list.sort_by(|a, b| (a.depth.total_cmp(&b.depth)).then(a.order.cmp(&b.order)));
    list.truncate(n as usize);
    list
}

/// What the pseudocode keeps of a list as it lies in the manager's memory: linked lists are read from the last that came.
fn emulated(list: &[Fragment], options: &ABufferOptions) -> Vec<u32> {
    let mut in_memory = list.to_vec();
    if options.manager == Manager::Ppll {
        in_memory.reverse();
    }
    let (algorithm, amendments) = match (options.pp_ao, options.keep) {
        (false, Keep::First) => (STATIC_ARRAY, vec![]),
        (false, Keep::Nearest) => (STATIC_ARRAY, vec![KEEP_NEAREST]),
        (true, Keep::First) => (PP_AO, vec![PP_AO_AMENDMENT]),
        (true, Keep::Nearest) => (PP_AO, vec![PP_AO_KEEPING_NEAREST]),
    };
    let run = run_on_lists(&algorithm, &amendments, &[in_memory], options.array, 1).unwrap();
    sorted(run.pixels[0].composited.clone())
}

/// Every manager, fill, ppAO or not, sort and what is kept.
fn every_static(array: u32, pp_ao: &[bool]) -> Vec<ABufferOptions> {
    let mut all = Vec::new();
    for manager in MANAGERS {
        for fill in [Fill::Atomics, Fill::Automatic] {
            for &pp_ao in pp_ao {
                for sort in [ArraySort::Network, ArraySort::Insertion] {
                    for keep in [Keep::First, Keep::Nearest] {
                        all.push(ABufferOptions {
                            manager,
                            fill,
                            pp_ao,
                            sort,
                            keep,
                            array,
                            color: RecordColor::Float,
                            ..ABufferOptions::DEFAULT
                        });
                    }
                }
            }
        }
    }
    all
}

/// With atomics fragments come as the driver runs them, and few are known to run a pixel's in their order.
fn comes_in_order(context: &Context, fill: Fill) -> bool {
    let driver = context.driver();
    driver.quirks().runs_in_order
        || fill == Fill::Automatic && driver.has("GL_EXT_shader_framebuffer_fetch")
}

#[test]
pub(crate) fn l09_a_full_array_keeps_what_each_manager_s_list_begins_with() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for (name, levels) in orders() {
        let stack = with_bits(&levels);
        let list = fragments(&stack.pixels[0]);
        let mut scene = stack.scene();
        scene.background = [0.0; 3];
        for options in every_static(ARRAY, &[false, true]) {
            if options.keep == Keep::First && !comes_in_order(&context, options.fill) {
                eprintln!("skipped: {:?}, whose order is the driver's", options.fill);
                continue;
            }
            let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
            let kept = survivors(&frame.image);
            let expected: Vec<u32> = match (options.keep, options.manager) {
                (Keep::First, Manager::Ffb | Manager::Dfb) => (0..8).collect(),
                (Keep::First, Manager::Ppll) => (4..12).collect(),
                (Keep::Nearest, _) => {
                    let orders = nearest(&list, ARRAY).iter().map(|f| f.order).collect();
                    sorted(orders)
                }
            };
            assert_eq!(kept, expected, "{name}: {options:?}");
            assert_eq!(emulated(&list, &options), expected, "{name}: {options:?}");
            assert_eq!(frame.stats.lost, Some(4));
            assert_eq!(frame.stats.a_buffer.unwrap().truncated_pixels, 1);
        }
    }
}

#[test]
fn a_missing_bit_would_be_noticed() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for missing in 0..COUNT {
        let mut stack = with_bits(&orders()[2].1);
        stack.pixels[0].remove(missing);
        let mut scene = stack.scene();
        scene.background = [0.0; 3];
        let frame = renderer.render(&scene, &Method::Exact).unwrap();
        let others: Vec<u32> = (0..COUNT as u32).filter(|&k| k != missing as u32).collect();
        assert_eq!(survivors(&frame.image), others);
    }
}

/// What the table of methods says is what the test above finds.
#[test]
fn the_registry_says_what_a_full_array_keeps() {
    for entry in registry() {
        let expected = match entry.method {
            Method::ABuffer(options) if !options.pp_dp => match options.manager {
                Manager::Ffb | Manager::Dfb => Some("the first submitted"),
                Manager::Ppll => Some("the last submitted"),
            },
            _ => None,
        };
        assert_eq!(entry.keeps, expected, "{}", entry.name);
    }
}

/// The oracle's image of each pixel's n nearest: the stack without its other fragments.
fn of_the_nearest(stack: &Stack, n: u32) -> (Stack, u64) {
    let mut lost = 0;
    let opaque = stack.opaque.map_or(f32::INFINITY, f32::from);
    let keep = |pieces: &Vec<Piece>| {
        let mut list = fragments(pieces);
        list.retain(|fragment| fragment.depth < opaque);
        let kept = sorted(nearest(&list, n).iter().map(|f| f.order).collect());
        lost += (list.len() - kept.len()) as u64;
        kept.iter().map(|&k| pieces[k as usize].clone()).collect()
    };
    let pixels = stack.pixels.iter().map(keep).collect();
    let kept = Stack {
        pixels,
        ..stack.clone()
    };
    (kept, lost)
}

/// Random stacks of up to 12 fragments a pixel, with ties and alphas of 0 and 1; arrays of 1 and 8.
#[test]
pub(crate) fn l09_keeping_the_nearest_gives_the_oracle_s_image_of_the_nearest_n() {
    let context = Context::headless().unwrap();
    let renderer = RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    let mut combinations = every_static(8, &[false, true]);
    combinations.extend(every_static(1, &[false]));
    combinations.retain(|options| options.keep == Keep::Nearest);
    for levels in [4, stack::LEVELS] {
        let ran = runner(12).run(&stacks(levels, false), |stack| {
            let scene = stack.scene();
            for options in &combinations {
                let (kept, lost) = of_the_nearest(&stack, options.array);
                let frame = renderer
                    .borrow_mut()
                    .render(&scene, &Method::ABuffer(*options))
                    .unwrap();
                let error = Comparison::new(&frame.image, &kept.expected(), F32).unwrap();
                if error.over > 0 || frame.stats.lost != Some(lost) {
                    let what = format!("{options:?}: {error:?}, {lost} lost\n{}", frame.stats);
                    return Err(TestCaseError::fail(what));
                }
            }
            Ok(())
        });
        if let Err(TestError::Fail(why, stack)) = ran {
            panic!("{why}\nthe smallest stack: {stack:#?}");
        }
    }
}

/// Deep pixels: where llvmpipe has too few iterations for insertion, elements are moved by constant indices.
#[test]
fn the_nearest_are_kept_of_a_thousand_fragments_too() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 2, 1).unwrap();
    for (count, array) in [(300, 16), (1000, 64), (700, 256)] {
        let stack = Stack {
            width: 2,
            pixels: vec![scattered(count, 1, 997), scattered(9, 2, 997)],
            opaque: None,
        };
        let (kept, lost) = of_the_nearest(&stack, array);
        let options = ABufferOptions {
            array,
            keep: Keep::Nearest,
            color: RecordColor::Float,
            ..small(Manager::Ppll)
        };
        let frame = renderer
            .render(&stack.scene(), &Method::ABuffer(options))
            .unwrap();
        assert_eq!(frame.stats.lost, Some(lost));
        let error = Comparison::new(&frame.image, &kept.expected(), F32).unwrap();
        assert_eq!(error.over, 0, "{count} {array}: {error:?}");
    }
}

/// As many fragments are lost whatever is kept, but not as much of the image: of 24 panes, white ones behind black ones, the
/// nearest 8 leave 0.6^8 = 0.017 of what is behind them.
#[test]
pub(crate) fn what_is_kept_decides_how_wrong_the_image_is() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let front_to_back: Vec<Piece> = (0..24)
        .map(|place| {
            let light = if place < 8 { 0.0 } else { 1.0 };
            Piece {
                level: 10 * (place + 1),
                color: [light, light, light, 0.4],
            }
        })
        .collect();
    let back_to_front = front_to_back.iter().rev().cloned().collect();
    let good = [Manager::Ffb, Manager::Dfb];
    for (pieces, keeps_the_nearest) in [
        (front_to_back, &good[..]),
        (back_to_front, &[Manager::Ppll]),
    ] {
        let stack = Stack {
            width: 1,
            pixels: vec![pieces],
            opaque: None,
        };
        let mut error = |options: ABufferOptions| {
            let frame = renderer
                .render(&stack.scene(), &Method::ABuffer(options))
                .unwrap();
            assert_eq!(frame.stats.lost, Some(16), "{options:?}");
            Comparison::new(&frame.image, &stack.expected(), F16)
                .unwrap()
                .max
        };
        for options in MANAGERS.map(|manager| ABufferOptions {
            array: ARRAY,
            ..small(manager)
        }) {
            let nearest = ABufferOptions {
                keep: Keep::Nearest,
                ..options
            };
            assert!(error(nearest) < 0.017 + F16);
            if comes_in_order(&context, options.fill) {
                let small = error(options) < 0.017 + F16;
                let large = error(options) > 0.4;
                let expected = keeps_the_nearest.contains(&options.manager);
                assert_eq!((small, large), (expected, !expected), "{options:?}");
            }
        }
    }
}

/// The eye in the fog, a pane that hides all but a millionth before its far face, and room for the pane alone. That the fog
/// is left, and so that the ray begins in it, says the face that is dropped; the first of the list do not say it, or are
/// that face without the pane.
#[test]
fn a_ray_begins_in_a_volume_whose_face_is_dropped_as_too_far() {
    let context = Context::headless().unwrap();
    let scene = fog_and_pane(0.75, -0.4, 0.999_999, 0.3);
    let mut renderer = Renderer::new(&context, scene.size[0], scene.size[1]).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap().image;
    for manager in MANAGERS {
        for sort in [ArraySort::Network, ArraySort::Insertion] {
            let options = ABufferOptions {
                array: 1,
                keep: Keep::Nearest,
                color: RecordColor::Float,
                sort,
                ..small(manager)
            };
            let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
            let error = Comparison::new(&frame.image, &exact, F32).unwrap();
            assert_eq!(error.over, 0, "{options:?}: {error:?}");
            let pixels = u64::from(scene.size[0] * scene.size[1]);
            assert_eq!(frame.stats.lost, Some(pixels), "the far face's fragments");
            let first = ABufferOptions {
                keep: Keep::First,
                ..options
            };
            let frame = renderer.render(&scene, &Method::ABuffer(first)).unwrap();
            let error = Comparison::new(&frame.image, &exact, F32).unwrap();
            assert_eq!(error.over as u64, pixels, "{first:?}: {error:?}");
            assert_eq!(frame.stats.lost, Some(pixels));
        }
    }
}

#[test]
fn keeping_the_nearest_is_refused_where_it_means_nothing() {
    let good = ABufferOptions {
        keep: Keep::Nearest,
        ..ABufferOptions::DEFAULT
    };
    good.check().unwrap();
    for (options, word) in [
        (
            ABufferOptions {
                pp_dp: true,
                ..good
            },
            "drops no fragment",
        ),
        (
            ABufferOptions {
                pp_ao: true,
                reading: onionskin::options::Reading::AsPrinted,
                ..good
            },
            "as printed",
        ),
    ] {
        let text = options.check().unwrap_err().to_string();
        assert!(text.contains(word), "{text}");
    }
}
