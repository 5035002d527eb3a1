//! The emulated pixel and OpenGL are the same machine: stencil, depth and samples bit for bit after every draw and every
//! copy, colours within rounding, on random sequences, in every format, by every method.
//!
//! `ONIONSKIN_SEED` repeats a run; a failing case shrinks to a short fragment list.

use crate::kit::driver::fixed_depths_are_products;
use crate::kit::peels;
use crate::kit::stack;
use onionskin::low_level::emulator::{Emulator, Group, Surface};
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::papers::carr_2008::hybrid::{Z_PEEL, Z_PEEL_NEXT};
use onionskin::low_level::papers::carr_2008::{D_SC, D_SN, DEPTH_BUFFER, Z_MIN_POST, Z_MIN_PREV};
use onionskin::low_level::papers::stage::ACCUMULATED;
use onionskin::low_level::steps::{Amendment, Call, Machine, Query, gl::*};
use onionskin::{Context, Format, Mesh, Scene, steps};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::chance::Chance;
use crate::kit::lockstep::{LockStep, Watched, surfaces};
use crate::kit::peels::Loop;
use crate::kit::stack::{LEVELS, Piece, Stack};

/// Sequences in the large image: one a pixel.
const SIDE: u32 = 100;

/// A random list a pixel: any number of surfaces from 0 to 10, on few or on many depths, sorted, reversed or anyhow.
pub(crate) fn random_stack(seed: u64) -> Stack {
    let mut chance = Chance::new(seed);
    let pixels = (0..SIDE * SIDE).map(|_| {
        let count = chance.below(11);
        let levels = [4, 16, 900][chance.below(3)];
        let mut pieces: Vec<Piece> = (0..count)
            .map(|_| Piece {
                level: (chance.below(levels) * (usize::from(LEVELS) / levels)) as u16,
                color: std::array::from_fn(|_| chance.below(256) as f32 / 255.0),
            })
            .collect();
        match chance.below(4) {
            0 => pieces.sort_by_key(|piece| piece.level),
            1 => pieces.sort_by_key(|piece| std::cmp::Reverse(piece.level)),
            _ => {}
        }
        pieces
    });
    Stack {
        width: SIDE,
        pixels: pixels.collect(),
        opaque: Some(700),
    }
}

/// The scene of a stack; for hybrid layer peeling with another one, front to back, as sorted geometry.
fn scene_of(stack: &Stack, which: Loop) -> Scene {
    let mut scene = stack.scene();
    if which == Loop::Hybrid {
        let mut slices = stack.clone();
        slices.opaque = None;
        for pieces in &mut slices.pixels {
            pieces.reverse();
            pieces.sort_by_key(|piece| piece.level);
        }
        scene
            .meshes
            .extend(slices.scene().meshes.into_iter().map(|mesh| Mesh {
                sorted: true,
                ..mesh
            }));
    }
    scene
}

/// Runs a loop on both machines, comparing all the way. Returns how many comparisons that were.
fn in_lock_step(
    context: &Context,
    stack: &Stack,
    which: Loop,
    amendments: &[Amendment],
    [color, depth]: [Format; 2],
) -> usize {
    let scene = scene_of(stack, which);
    let mut gl = GlMachine::new(context, scene.size).unwrap();
    which.allocate_maps(&mut gl, color, depth);
    gl.set_geometry(Geometry::upload(context, &scene, scene.size).unwrap());
    gl.begin_frame();
    let pixels = surfaces(&mut gl, &scene, peels::IMAGE);
    let mut emulator = Emulator::new(pixels.clone());
    which.allocate_maps(&mut emulator, color, depth);
    gl.begin_frame();
    let depths = [
        DEPTH_BUFFER,
        D_SC,
        D_SN,
        Z_MIN_POST,
        Z_MIN_PREV,
        Z_PEEL,
        Z_PEEL_NEXT,
    ];
    let mut watched: Vec<Watched> = depths.map(|map| Watched { map, format: depth }).to_vec();
    if which == Loop::B {
        watched.retain(|watched| watched.map != Z_MIN_PREV);
        watched.push(Watched {
            map: Z_MIN_PREV,
            format: color,
        });
    }
    watched.push(Watched {
        map: ACCUMULATED,
        format: color,
    });
    let transparent = |surfaces: &Vec<Surface>| surfaces.iter().any(|s| s.group != Group::Opaque);
    let mut both = LockStep::new(
        &mut gl,
        &mut emulator,
        watched,
        (0..pixels.len())
            .filter(|&p| transparent(&pixels[p]))
            .collect(),
        color_bound(color),
    );
    let deepest = pixels.iter().map(Vec::len).max().unwrap_or(0);
    which.run(&mut both, amendments, deepest as f64 + 2.0);
    both.compared
}

/// What a color may differ by after up to 20 blends: nothing in f32, where both round the same two products and their
/// sum; a step per blend where the target has fewer bits, because drivers may blend with fewer.
pub(crate) fn color_bound(format: Format) -> f32 {
    match format {
        Format::Rgba8 => 20.0 / 255.0,
        Format::Rgba16F => 20.0 / 2048.0,
        _ => 0.0,
    }
}

fn check(which: Loop, formats: [Format; 2]) {
    let context = Context::headless().unwrap();
    let seed = 2008;
    let compared = in_lock_step(
        &context,
        &random_stack(seed),
        which,
        &which.amendments(),
        formats,
    );
    println!("{which:?} {formats:?}: {compared} comparisons, seed {seed}");
    assert!(compared > 500_000, "{compared}");
}

const F32: Format = Format::Rgba32F;
const D32F: Format = Format::Depth32FStencil8;
const D24: Format = Format::Depth24Stencil8;
const D16: Format = Format::Depth16;

#[test]
fn ten_thousand_sequences_by_coherent_layer_peeling_a() {
    check(Loop::A, [F32, D32F]);
}

#[test]
fn ten_thousand_sequences_by_coherent_layer_peeling_b() {
    check(Loop::B, [F32, D32F]);
}

#[test]
fn ten_thousand_sequences_by_layer_peeling() {
    check(Loop::LayerPeeling, [F32, D32F]);
}

#[test]
fn ten_thousand_sequences_by_hybrid_layer_peeling() {
    check(Loop::Hybrid, [F32, D32F]);
}

#[test]
fn ten_thousand_sequences_on_24_bit_depths_as_llvmpipe_samples_them() {
    if !fixed_depths_are_products(&Context::headless().unwrap()) {
        return;
    }
    for which in peels::LOOPS {
        check(which, [F32, D24]);
    }
}

#[test]
fn ten_thousand_sequences_on_16_bit_depths_as_llvmpipe_samples_them() {
    if !fixed_depths_are_products(&Context::headless().unwrap()) {
        return;
    }
    // Without a stencil there is no coherent layer peeling.
    for which in [Loop::LayerPeeling, Loop::Hybrid] {
        check(which, [F32, D16]);
    }
}

#[test]
fn ten_thousand_sequences_with_small_colors() {
    // Variant B's depths are colors: that they need 32 bits is CX17.
    for which in [Loop::LayerPeeling, Loop::Hybrid, Loop::A] {
        for color in [Format::Rgba16F, Format::Rgba8] {
            check(which, [color, D32F]);
        }
    }
}

#[test]
fn the_text_as_printed_goes_wrong_in_the_same_way_on_both() {
    let context = Context::headless().unwrap();
    let stack = random_stack(1);
    for which in [Loop::A, Loop::B, Loop::Hybrid] {
        let compared = in_lock_step(&context, &stack, which, &[], [F32, D32F]);
        assert!(compared > 1_000_000, "{compared}");
    }
}

#[test]
fn random_sequences_that_shrink() {
    let context = Context::headless().unwrap();
    let strategy = stack::stacks(12, false);
    let result = stack::runner(40).run(&strategy, |stack| {
        for which in [Loop::A, Loop::B, Loop::LayerPeeling] {
            let case = std::panic::AssertUnwindSafe(|| {
                in_lock_step(&context, &stack, which, &which.amendments(), [F32, D32F]);
            });
            if std::panic::catch_unwind(case).is_err() {
                return Err(TestCaseError::fail(format!("{which:?}")));
            }
        }
        Ok(())
    });
    if let Err(TestError::Fail(why, stack)) = result {
        panic!("{why}: {stack:#?}");
    }
}

#[test]
fn one_fragment_off_by_its_last_bit_would_be_noticed() {
    let context = Context::headless().unwrap();
    let stack = Stack {
        width: 1,
        pixels: vec![vec![Piece {
            level: 500,
            color: [0.5; 4],
        }]],
        opaque: None,
    };
    let scene = stack.scene();
    let mut gl = GlMachine::new(&context, scene.size).unwrap();
    Loop::A.allocate_maps(&mut gl, F32, D32F);
    gl.set_geometry(Geometry::upload(&context, &scene, scene.size).unwrap());
    gl.begin_frame();
    let mut pixels = surfaces(&mut gl, &scene, peels::IMAGE);
    let depth = &mut pixels[0][0].fragment.depth;
    *depth = depth.next_up();
    let mut emulator = Emulator::new(pixels);
    Loop::A.allocate_maps(&mut emulator, F32, D32F);
    gl.begin_frame();
    let mut both = LockStep::new(
        &mut gl,
        &mut emulator,
        vec![Watched {
            map: D_SN,
            format: D32F,
        }],
        vec![0],
        0.0,
    );
    let run = std::panic::AssertUnwindSafe(|| Loop::A.run(&mut both, &Loop::A.amendments(), 9.0));
    let panic = std::panic::catch_unwind(run).expect_err("it is noticed");
    let said = panic.downcast_ref::<String>().expect("words");
    assert!(said.contains("OpenGL has depth"), "{said}");
}

#[test]
fn stencil_operations_agree_one_by_one() {
    // Every operation in each of its three places, over values that saturate and wrap.
    const OPS: [onionskin::low_level::steps::StencilOp; 8] = {
        use onionskin::low_level::steps::StencilOp::*;
        [Keep, Zero, Replace, Incr, IncrWrap, Decr, DecrWrap, Invert]
    };
    let context = Context::headless().unwrap();
    let stack = random_stack(3);
    for (place, op) in (0..3).flat_map(|place| OPS.map(|op| (place, op))) {
        let amendment = [
            op,
            onionskin::low_level::steps::StencilOp::Keep,
            onionskin::low_level::steps::StencilOp::Keep,
        ];
        let [sfail, dpfail, dppass] = std::array::from_fn(|i| amendment[(i + 3 - place) % 3]);
        let scene = stack.scene();
        let mut gl = GlMachine::new(&context, scene.size).unwrap();
        Loop::A.allocate_maps(&mut gl, F32, D32F);
        gl.set_geometry(Geometry::upload(&context, &scene, scene.size).unwrap());
        gl.begin_frame();
        let pixels = surfaces(&mut gl, &scene, peels::IMAGE);
        let mut emulator = Emulator::new(pixels.clone());
        Loop::A.allocate_maps(&mut emulator, F32, D32F);
        gl.begin_frame();
        let mut both = LockStep::new(
            &mut gl,
            &mut emulator,
            vec![Watched {
                map: DEPTH_BUFFER,
                format: D32F,
            }],
            (0..pixels.len()).collect(),
            0.0,
        );
        const COUNTED: Query = Query("counted");
        for step in steps! {
            glBindFramebuffer(onionskin::low_level::papers::stage::PEEL);
            glClearStencil(253);
            glClear(DEPTH_AND_STENCIL_BUFFER_BITS);
            glEnable(DEPTH_TEST);
            glEnable(STENCIL_TEST);
            glStencilFunc(NOTEQUAL, 1, 0xFF);
            glStencilMask(0x7F);
            glUseProgram(onionskin::low_level::papers::stage::SURFACE);
        } {
            let onionskin::low_level::steps::Step::Call(call) = step else {
                unreachable!("there are only calls")
            };
            both.perform(call).unwrap();
        }
        both.perform(&Call::StencilOp {
            sfail,
            dpfail,
            dppass,
        })
        .unwrap();
        both.perform(&Call::BeginQuery { query: COUNTED }).unwrap();
        both.perform(&Call::Draw {
            objects: onionskin::low_level::steps::Objects::Transparent,
        })
        .unwrap();
        both.perform(&Call::EndQuery { query: COUNTED }).unwrap();
        both.samples(COUNTED).unwrap();
        assert_eq!(
            both.compared,
            2 * pixels.len(),
            "one clear and one draw, compared everywhere"
        );
    }
}
