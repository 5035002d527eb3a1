//! The words of depth peeling's improvements: each is needed, and the emulated pixel and OpenGL agree on them.

use crate::kit::bounds::F32;
use crate::kit::changed::changed;
use crate::kit::lockstep::{LockStep, Watched, surfaces};
use crate::kit::peels::IMAGE;
use crate::kit::stack::{Piece, Stack};
use crate::kit::vtk_scenes::{peel, staircase};
use crate::peeling_improved::*;
use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{Amendment, Map, Reason, Shader, gl::*};
use onionskin::options::DepthPeelingOptions;
use onionskin::{Context, Format, steps};

#[test]
fn a_changed_word_of_an_improvement_is_noticed() {
    let context = Context::headless().unwrap();
    let stack = Stack {
        opaque: Some(900),
        ..staircase()
    };
    let right = peel(&context, &stack, PLAIN);
    for (name, options, amendments) in CHANGES {
        let options = DepthPeelingOptions {
            maximum_number_of_peels: 12,
            amendments,
            ..options
        };
        let frame = peel(&context, &stack, options);
        let same = frame.image == right.image
            && frame.stats.layers == right.stats.layers
            && frame.stats.lost == right.stats.lost;
        assert!(!same, "{name} was not noticed");
    }
}

const FIRST: Shader = Shader("alive/first");

const LATER: Shader = Shader("alive/later");

/// One changed word each. The caller's amendments hold before the improvements, so each is an improvement's, changed.
const CHANGES: [(&str, DepthPeelingOptions, &[Amendment]); 5] = [
    (
        "the depths of the last layers left in the next peel's buffer",
        ALIVE,
        &[changed(
            steps! { glBindFramebuffer(stage::ACCUMULATION); glEnable(BLEND); },
            steps! {
                glBindFramebuffer(stage::ACCUMULATION);
                glFramebufferDepth(Map::at("depth buffer", "A"));
                glDepthFunc(ALWAYS);
                glEnable(BLEND);
            },
        )],
    ),
    (
        "LESS for ALWAYS",
        ALIVE,
        &[changed(
            steps! { glBindFramebuffer(stage::ACCUMULATION); glEnable(BLEND); },
            steps! {
                glBindFramebuffer(stage::ACCUMULATION);
                glFramebufferDepth(Map::at("depth buffer", "A"));
                glClearDepth(0.0);
                glClear(DEPTH_BUFFER_BIT);
                glDepthFunc(LESS);
                glEnable(BLEND);
            },
        )],
    ),
    (
        "dead pixels taken for a layer",
        ALIVE,
        &[changed(
            steps! { glUseProgram(vtk::UNDER_LAYER); },
            steps! { glUseProgram(FIRST); },
        )],
    ),
    (
        "what is under, without a depth for the next peel",
        ALIVE,
        &[changed(
            steps! { glUseProgram(vtk::UNDER_LAYER); },
            steps! { if (i == 0) { glUseProgram(FIRST); } else { glUseProgram(vtk::UNDER_LAYER); } },
        )],
    ),
    (
        // The count is read all the same. llvmpipe empties a query that begins again without waiting for the threads that
        // still count for it, and a count that nobody read has been seen to come back in the next one.
        "the count of the first layer forgotten",
        DepthPeelingOptions {
            maximum_number_of_peels: 4,
            ..LATE
        },
        &[changed(
            vtk::QUERY.amended,
            steps! {
                drawTransparentObjects();
                peels = i + 1;
                if (i > 0) {
                    pixels = samples(PIXELS);
                    stop if (pixels == 0) because EmptyLayer;
                    if (i > 1) { composited = composited + pixels; }
                    num_layers = i;
                }
            },
        )],
    ),
];

const PIXELS: onionskin::low_level::steps::Query = onionskin::low_level::steps::Query("pixels");

#[test]
fn a_first_layer_at_depth_0_is_not_taken_for_a_dead_pixel() {
    use crate::kit::peels::{before, expected_color, pixel};
    let pixels = vec![
        pixel([0.5, 0.0]),
        pixel([0.0]),
        before(pixel([0.25, 0.0, 0.75]), 0.5),
    ];
    let colors = |amendments: &[Amendment]| {
        let mut emulator = Emulator::new(pixels.clone());
        allocate(&mut emulator, D32F);
        on_the_fly(&mut emulator, amendments, f64::INFINITY);
        emulator.colors(IMAGE).unwrap().to_vec()
    };
    let alive = colors(&vtk::ALIVE);
    assert_eq!(alive, colors(&[]));
    for (pixel, color) in pixels.iter().zip(&alive) {
        for (found, expected) in color.iter().zip(expected_color(pixel)).take(3) {
            assert!((f64::from(*found) - expected).abs() < F32, "{color:?}");
        }
    }
    // The later layers' shader would.
    let mut later = vec![changed(
        steps! { glUseProgram(vtk::UNDER_LAYER); },
        steps! { glUseProgram(LATER); },
    )];
    later.extend(vtk::ALIVE);
    assert_ne!(colors(&later), alive);
}

#[test]
fn the_emulated_pixel_and_opengl_agree_all_the_way() {
    let context = Context::headless().unwrap();
    let piece = |pixel: u16, n: u16| Piece {
        level: (pixel * 37 + n * 331) % 9 * 100,
        color: [
            f32::from(pixel % 7) / 7.0,
            f32::from(n) / 9.0,
            0.25,
            0.1 + f32::from((pixel + n) % 9) / 10.0,
        ],
    };
    let pixels = (0..900).map(|pixel| (0..pixel % 9).map(|n| piece(pixel, n)).collect());
    let stack = Stack {
        width: 30,
        pixels: pixels.collect(),
        opaque: Some(650),
    };
    let scene = stack.scene();
    for amendments in [
        vtk::LATE_QUERY.to_vec(),
        vtk::ALIVE.to_vec(),
        [vtk::LATE_QUERY, vtk::ALIVE].concat(),
    ] {
        let mut gl = machine(&context, &scene, D32F);
        let pixels = surfaces(&mut gl, &scene, IMAGE);
        let mut emulator = Emulator::new(pixels.clone());
        allocate(&mut emulator, D32F);
        gl.begin_frame();
        let depths = vtk::DEPTH_BUFFERS.map(|map| Watched { map, format: D32F });
        let colors = Watched {
            map: stage::ACCUMULATED,
            format: Format::Rgba32F,
        };
        let watched = [&depths[..], &[colors]].concat();
        let all = (0..pixels.len()).collect();
        let mut both = LockStep::new(&mut gl, &mut emulator, watched, all, 0.0);
        let outcome = on_the_fly(&mut both, &amendments, f64::INFINITY);
        assert_eq!(outcome.stopped, Some(Reason::EmptyLayer));
        println!("{} comparisons", both.compared);
        assert!(both.compared > 30_000, "{}", both.compared);
    }
}
