//! ppAO and ppDP twice on the same random stacks: the paper's pseudocode line by line on the emulator's lists, and the
//! shaders on OpenGL. The same fragments, walks, records and Local Array elements, as printed and as amended.

use crate::kit::bounds::F32;
use crate::kit::driver::keeps_lists_in_order;
use crate::kit::stack;
use std::cell::{Cell, RefCell};

use onionskin::low_level::emulator::{ListRun, run_on_lists};
use onionskin::low_level::papers::lindholm_2015::components::*;
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::Pseudocode;
use onionskin::low_level::steps::pseudo::list::{Counter, ListLine, Mark};
use onionskin::options::{ABufferOptions, Fill, Keep, Manager, Reading, RecordColor};
use onionskin::{Comparison, Context, Fragment, Image, Method, Renderer};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::a_buffer::MANAGERS;
use crate::kit::masks::stencil;
use crate::kit::stack::{Stack, fragments, runner, stacks};

/// The same on both sides.
struct Twins {
    name: &'static str,
    algorithm: Pseudocode<ListLine>,
    amendments: Vec<Amendment<ListLine>>,
    options: ABufferOptions,
}

impl Twins {
    fn array(&self) -> u32 {
        match self.options.pp_dp && !self.options.pp_ao {
            true => self.options.peel,
            false => self.options.array,
        }
    }

    /// A pixel's list as it lies in memory: linked lists are read from the last that came.
    fn in_memory(&self, mut list: Vec<Fragment>) -> Vec<Fragment> {
        if self.options.manager == Manager::Ppll {
            list.reverse();
        }
        list
    }
}

fn twins() -> Vec<Twins> {
    let mut all = Vec::new();
    let mut add = |name, algorithm, amendments: &[_], options| {
        all.push(Twins {
            name,
            algorithm,
            amendments: amendments.to_vec(),
            options: ABufferOptions {
                color: RecordColor::Float,
                ..options
            },
        });
    };
    for manager in MANAGERS {
        let options = ABufferOptions {
            manager,
            array: 8,
            ..ABufferOptions::DEFAULT
        };
        for peel in [1, 3, 8] {
            let options = ABufferOptions {
                pp_dp: true,
                peel,
                ..options
            };
            add("ppDP", PP_DP, &PP_DP_AMENDMENTS, options);
            let read = |reading| ABufferOptions { reading, ..options };
            add("ppDP as printed", PP_DP, &[STOP], read(Reading::AsPrinted));
            if peel != 3 {
                continue;
            }
            // The order in memory decides between equal depths, so the order of the fill is looked at, too.
            let by_atomics = ABufferOptions {
                fill: Fill::Atomics,
                ..read(Reading::AsPrinted)
            };
            add("ppDP as printed, by atomics", PP_DP, &[STOP], by_atomics);
            add("ppDP literally", PP_DP, &[], read(Reading::Literal));
        }
        let nearest = |options| ABufferOptions {
            keep: Keep::Nearest,
            ..options
        };
        for array in [1, 4, 8] {
            let options = ABufferOptions { array, ..options };
            add("static", STATIC_ARRAY, &[], options);
            let nearest = nearest(options);
            add("static, nearest", STATIC_ARRAY, &[KEEP_NEAREST], nearest);
        }
        let pp_ao = ABufferOptions {
            pp_ao: true,
            ..options
        };
        add("ppAO", PP_AO, &[PP_AO_AMENDMENT], pp_ao);
        let nearest = nearest(pp_ao);
        add("ppAO, nearest", PP_AO, &[PP_AO_KEEPING_NEAREST], nearest);
        let both = ABufferOptions {
            pp_dp: true,
            ..pp_ao
        };
        add("ppAO + ppDP", PP_AO, &[PP_AO_WITH_PP_DP], both);
        let as_printed = ABufferOptions {
            reading: Reading::AsPrinted,
            ..pp_ao
        };
        let invert = stencil(Counter::Stencil, Mark::Invert);
        add("ppAO as printed", PP_AO, &invert, as_printed);
    }
    all
}

/// What the Fill Step leaves of a stack's pixels: what lies before the opaque surface.
fn lists(stack: &Stack) -> Vec<Vec<Fragment>> {
    let opaque = stack.opaque.map_or(f32::INFINITY, f32::from);
    let list = |pieces: &Vec<_>| {
        let mut list = fragments(pieces);
        list.retain(|fragment| fragment.depth < opaque);
        list.iter_mut().for_each(|fragment| fragment.depth += 1.0);
        list
    };
    stack.pixels.iter().map(list).collect()
}

/// The image of the fragments that the emulator has composited, front to back, over what lies behind them.
fn image(stack: &Stack, run: &ListRun) -> Image {
    let behind = Stack {
        pixels: vec![Vec::new(); stack.pixels.len()],
        ..stack.clone()
    };
    let mut image = behind.expected();
    for ((pixel, pieces), seen) in image.pixels.iter_mut().zip(&stack.pixels).zip(&run.pixels) {
        let mut sum = [0.0; 3];
        let mut transparency = 1.0;
        for &order in &seen.composited {
            let [r, g, b, a] = pieces[order as usize].color.map(f64::from);
            for (sum, channel) in sum.iter_mut().zip([r, g, b]) {
                *sum += transparency * a * channel;
            }
            transparency *= 1.0 - a;
        }
        let [r, g, b, _] = pixel
            .to_array()
            .map(|channel| f64::from(channel) * transparency);
        *pixel = [sum[0] + r, sum[1] + g, sum[2] + b, 1.0]
            .map(|channel| channel as f32)
            .into();
    }
    image
}

/// Says where they part, if they do; otherwise how many fragments were lost.
fn difference(renderer: &mut Renderer<'_>, twins: &Twins, stack: &Stack) -> Result<u64, String> {
    let lists = lists(stack);
    let in_memory: Vec<_> = lists
        .iter()
        .map(|list| twins.in_memory(list.clone()))
        .collect();
    // Each by itself: the shader gives a list up after one more subpass than it has fragments.
    let resolved = |list: &Vec<Fragment>| {
        let limit = list.len() as u32 + 1;
        let list = std::slice::from_ref(list);
        run_on_lists(
            &twins.algorithm,
            &twins.amendments,
            list,
            twins.array(),
            limit,
        )
    };
    let runs: Result<Vec<ListRun>, _> = in_memory.iter().map(resolved).collect();
    let runs = runs.map_err(|error| error.to_string())?;
    let run = ListRun {
        ended: runs.iter().all(|run| run.ended),
        pixels: runs.into_iter().flat_map(|run| run.pixels).collect(),
    };
    let frame = renderer
        .render(&stack.scene(), &Method::ABuffer(twins.options))
        .map_err(|error| error.to_string())?;
    let counts = frame.stats.a_buffer.ok_or("an A-buffer counts")?;
    // Pixels without a fragment are not drawn.
    let drawn = || {
        run.pixels
            .iter()
            .zip(&lists)
            .filter(|(_, list)| !list.is_empty())
    };
    let sum = |part: fn(&onionskin::low_level::emulator::Resolved) -> u32| {
        drawn()
            .map(|(pixel, _)| u64::from(part(pixel)))
            .sum::<u64>()
    };
    let composited = sum(|pixel| pixel.composited.len() as u32);
    let lost = lists.iter().map(Vec::len).sum::<usize>() as u64 - composited;
    let emulated = [
        ("lost", lost),
        ("subpasses", sum(|pixel| pixel.subpasses)),
        ("records read", sum(|pixel| pixel.records_read)),
        ("slots reserved", sum(|pixel| pixel.slots[0])),
        ("slots used", sum(|pixel| pixel.slots[1])),
    ];
    let on_gl = [
        frame.stats.lost.ok_or("lost fragments are counted")?,
        counts.subpasses,
        counts.records_read,
        counts.slots_reserved,
        counts.slots_used,
    ];
    for ((what, emulated), on_gl) in emulated.into_iter().zip(on_gl) {
        if emulated != on_gl {
            return Err(format!("{what}: {emulated} emulated, {on_gl} on OpenGL"));
        }
    }
    let error = Comparison::new(&frame.image, &image(stack, &run), F32)
        .map_err(|error| error.to_string())?;
    match error.over {
        0 => Ok(lost),
        _ => Err(format!("the images differ: {error:?}")),
    }
}

/// Ties are many on 4 levels.
#[test]
fn the_pseudocode_and_the_shaders_resolve_the_same_fragments() {
    let context = Context::headless().expect("a context");
    let renderer = RefCell::new(Renderer::new(&context, 3, 2).expect("a renderer"));
    if !keeps_lists_in_order(&context) {
        return;
    }
    for twins in twins() {
        let Twins { name, options, .. } = &twins;
        let lost = Cell::new(0);
        for levels in [4, 1000] {
            let checked = runner(40).run(&stacks(levels, false), |stack| {
                difference(&mut renderer.borrow_mut(), &twins, &stack)
                    .map(|more| lost.set(lost.get() + more))
                    .map_err(TestCaseError::fail)
            });
            if let Err(TestError::Fail(why, stack)) = checked {
                panic!("{name}, {options:?}: {why}\n{stack:?}");
            }
        }
        println!(
            "{name}, {:?}, {}: {} lost",
            options.manager,
            twins.array(),
            lost.get()
        );
        let loses = options.reading != Reading::Amended || !options.pp_dp;
        assert_eq!(lost.get() > 0, loses, "{name}");
    }
}

/// LX03: where no fragment is lost, waiting for all of them ends as soon as nothing is dropped. Where a tie is lost it never
/// would, in the shader as in the text.
#[test]
fn literally_the_shader_waits_for_a_lost_fragment_as_the_pseudocode_does() {
    let context = Context::headless().expect("a context");
    let mut renderer = Renderer::new(&context, 1, 1).expect("a renderer");
    let literal = |manager| Twins {
        name: "ppDP literally",
        algorithm: PP_DP,
        amendments: Vec::new(),
        options: ABufferOptions {
            manager,
            pp_dp: true,
            peel: 2,
            color: RecordColor::Float,
            reading: Reading::Literal,
            ..ABufferOptions::DEFAULT
        },
    };
    for manager in MANAGERS {
        let twins = literal(manager);
        for (levels, lost, subpasses, stopped) in [
            ([5, 1, 3, 2, 4], 0, 3, "done"),
            // The second of two at 3 is left over when the first subpass ends: 1 and a 3, then 4 and 5, and so on for nothing.
            ([5, 1, 3, 3, 4], 1, 6, "no end"),
        ] {
            let piece = |level| stack::Piece {
                level,
                color: [0.1 * f32::from(level), 0.5, 0.2, 0.4],
            };
            let stack = Stack {
                width: 1,
                pixels: vec![levels.map(piece).to_vec()],
                opaque: None,
            };
            assert_eq!(difference(&mut renderer, &twins, &stack), Ok(lost));
            let frame = renderer
                .render(&stack.scene(), &Method::ABuffer(twins.options))
                .unwrap();
            let counts = frame.stats.a_buffer.unwrap();
            assert_eq!(counts.subpasses, subpasses, "{levels:?}");
            assert!(frame.stats.stopped_text().starts_with(stopped));
        }
    }
}

/// Amended otherwise, each twin's pseudocode parts from its shader on ten fragments with ties where each array ends.
#[test]
fn an_algorithm_that_differs_would_be_noticed() {
    let context = Context::headless().expect("a context");
    let mut renderer = Renderer::new(&context, 3, 2).expect("a renderer");
    let pieces = |pixel: usize| {
        let piece = |number: usize| stack::Piece {
            level: [7, 3, 3, 9, 3, 1, 7, 3, 2, 7][number],
            color: [0.1 * number as f32, 0.15 * pixel as f32, 0.5, 0.4],
        };
        (0..10).map(piece).collect()
    };
    let stack = Stack {
        width: 3,
        pixels: (0..6).map(pieces).collect(),
        opaque: None,
    };
    if !keeps_lists_in_order(&context) {
        return;
    }
    for mut twins in twins() {
        assert!(
            difference(&mut renderer, &twins, &stack).is_ok(),
            "{}",
            twins.name
        );
        // ppAO's stencil and its text mean the same where there is one segment; its amendment does not.
        let ABufferOptions {
            pp_ao,
            pp_dp,
            keep,
            reading,
            ..
        } = twins.options;
        twins.amendments = match keep {
            Keep::First if reading == Reading::AsPrinted && pp_ao => {
                vec![PP_AO_AMENDMENT]
            }
            // What the array keeps is then not what the shader keeps.
            Keep::First if !pp_ao && !pp_dp => vec![KEEP_NEAREST],
            // A subpass that drops nothing is the last, even if ties were lost.
            Keep::First if reading == Reading::Literal => vec![STOP],
            Keep::Nearest if pp_ao => vec![PP_AO_AMENDMENT],
            _ => Vec::new(),
        };
        let other = difference(&mut renderer, &twins, &stack);
        assert!(other.is_err(), "{}", twins.name);
    }
}
