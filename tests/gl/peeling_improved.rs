//! The improvements of depth peeling: a query that is read a peel late, peels of the pixels alone that are alive, and peels
//! without the triangles that are finished. The image is the same to the last bit, and what they cost and spare is counted.

use crate::kit::bounds::F32;
use crate::kit::changed::changed;
use crate::kit::lockstep::{LockStep, Watched, surfaces};
use crate::kit::peels::IMAGE;
use crate::kit::render::example;
use crate::kit::stack::{self, LEVELS, Piece, Stack, runner, stacks};
use crate::kit::vtk_scenes::{nearest, over, peel, render, soup_scene, staircase};
use onionskin::generate::{Quads, Soup, SubmissionOrder, quads, soup};
use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{
    Amendment, DepthUnits, Map, Outcome, Reason, Shader, Variables, gl::*, run,
};
use onionskin::options::{Compositing, DepthPeelingOptions, Reading};
use onionskin::{Camera, Comparison, Context, Format, Method, Renderer, Scene, steps};
use proptest::test_runner::TestCaseError;

const PLAIN: DepthPeelingOptions = DepthPeelingOptions {
    maximum_number_of_peels: 0,
    occlusion_ratio: 0.0,
    compositing: Compositing::OnTheFly,
    late_query: false,
    alive: false,
    cull: false,
    reading: Reading::Amended,
    depth_unit_0: onionskin::options::DepthUnit0::Sampler,
    amendments: &[],
};
const LATE: DepthPeelingOptions = DepthPeelingOptions {
    late_query: true,
    ..PLAIN
};
const ALIVE: DepthPeelingOptions = DepthPeelingOptions {
    alive: true,
    ..PLAIN
};
const BOTH: DepthPeelingOptions = DepthPeelingOptions {
    late_query: true,
    ..ALIVE
};
const CULL: DepthPeelingOptions = DepthPeelingOptions {
    cull: true,
    ..PLAIN
};
const ALL: DepthPeelingOptions = DepthPeelingOptions { cull: true, ..BOTH };
const IMPROVED: [DepthPeelingOptions; 5] = [LATE, ALIVE, BOTH, CULL, ALL];

/// The staircase with and without something opaque, a soup, and a scene of meshes before an opaque plane.
fn scenes() -> Vec<Scene> {
    let before = |opaque| Stack {
        opaque,
        ..staircase()
    };
    let mut scenes = vec![soup_scene(), example("teapot", [120, 90])];
    scenes.extend([None, Some(50), Some(250), Some(900)].map(|opaque| before(opaque).scene()));
    scenes
}

#[test]
fn a_query_that_is_read_a_peel_late_costs_one_peel_and_changes_no_bit() {
    let context = Context::headless().unwrap();
    for scene in scenes() {
        let plain = render(&context, &scene, PLAIN);
        for options in [LATE, BOTH] {
            let late = render(&context, &scene, options);
            assert!(late.image == plain.image, "{}", scene.name);
            let layers = plain.stats.layers.unwrap();
            assert_eq!(plain.stats.geometry_passes, u64::from(layers) + 1);
            assert_eq!(
                (late.stats.geometry_passes, late.stats.iterations),
                (u64::from(layers) + 2, layers + 2)
            );
            assert_eq!(
                (late.stats.layers, late.stats.lost, late.stats.stopped),
                (plain.stats.layers, plain.stats.lost, plain.stats.stopped)
            );
        }
    }
}

#[test]
fn only_pixels_that_are_alive_are_peeled_and_no_bit_changes() {
    let context = Context::headless().unwrap();
    for scene in scenes() {
        let [plain, alive] = [PLAIN, ALIVE].map(|options| render(&context, &scene, options));
        assert!(alive.image == plain.image, "{}", scene.name);
        let counts = |stats: &onionskin::Stats| {
            (
                stats.geometry_passes,
                stats.layers,
                stats.lost,
                stats.stopped,
            )
        };
        assert_eq!(counts(&alive.stats), counts(&plain.stats));
    }
    // The staircase's six pixels have 4, 3, 2, 2, 1 and 1 fragments. After each peel, the next one's depth buffer.
    let layers = [4, 3, 2, 2, 1, 1];
    for peels in 1..=4 {
        let scene = staircase().scene();
        let mut gl = machine(&context, &scene, D32F);
        on_the_fly(&mut gl, &vtk::ALIVE, f64::from(peels));
        let next = gl.read_depths(vtk::DEPTH_BUFFERS[(peels as usize + 1) % 2]);
        // The rows come from the bottom.
        let rows: Vec<f32> = next.unwrap().chunks(3).rev().flatten().copied().collect();
        let expected = layers.map(|layers| if layers >= peels { 1.0 } else { 0.0 });
        assert_eq!(rows, expected, "{peels} peels");
    }
}

#[test]
fn culling_spares_the_triangles_that_are_finished_and_changes_no_bit() {
    let context = Context::headless().unwrap();
    println!("scene      layers  triangles    culled  alive, culled");
    let bundled = ["teapot", "knots", "molecule"].map(|name| example(name, [120, 90]));
    // Small triangles in every direction, many of them nearly edge on.
    let splinters = (0..8).map(|seed| {
        let splinters = Soup {
            triangle_size: [0.02, 0.6],
            seed,
            count: 2000,
            ..Soup::default()
        };
        let mut scene = Scene::of("splinters", vec![soup(&splinters).unwrap()]);
        scene.size = [160, 120];
        scene
    });
    for scene in bundled.into_iter().chain(splinters) {
        let plain = render(&context, &scene, PLAIN);
        let alive = DepthPeelingOptions {
            cull: true,
            ..ALIVE
        };
        let kept = DepthPeelingOptions {
            compositing: Compositing::KeepLayers,
            ..CULL
        };
        let [culled, alive, kept] =
            [CULL, alive, kept].map(|options| render(&context, &scene, options));
        println!(
            "{:10} {:6}  {:9} {:9} {:9}",
            scene.name,
            plain.stats.layers.unwrap(),
            plain.stats.triangles,
            culled.stats.triangles,
            alive.stats.triangles
        );
        assert!(culled.image == plain.image && alive.image == plain.image);
        let counts = |stats: &onionskin::Stats| (stats.layers, stats.fragments, stats.lost);
        for frame in [&culled, &alive, &kept] {
            assert_eq!(counts(&frame.stats), counts(&plain.stats), "{}", scene.name);
            assert!(frame.stats.triangles * 4 < plain.stats.triangles * 3);
        }
        assert_eq!(kept.layers.len(), plain.stats.layers.unwrap() as usize);
    }
}

/// A peel draws the sheets that the peels before have not found, and the last one that they have, which is not before
/// itself.
#[test]
fn of_sheets_one_behind_the_other_each_peel_draws_one_less() {
    let context = Context::headless().unwrap();
    for sheets in [1, 2, 7, 20_u32] {
        let parameters = Quads {
            count: sheets,
            size: [4.0, 3.0],
            spacing: 1.0 / sheets as f32,
            alpha: 0.1,
            order: SubmissionOrder::Shuffled,
            seed: 3,
            ..Quads::default()
        };
        let mut scene = Scene::of("sheets", vec![quads(&parameters).unwrap()]);
        scene.size = [16, 12];
        scene.camera = Camera::looking(glam::DVec3::Z * 4.0, glam::DVec3::ZERO);
        let sheets = u64::from(sheets);
        for options in [CULL, ALL] {
            let stats = render(&context, &scene, options).stats;
            // The late query's peel behind the empty one has nothing alive.
            let found: u64 = (1..=sheets).sum();
            assert_eq!(stats.triangles, 2 * (sheets + found), "{options:?}");
            assert_eq!(stats.geometry_passes, sheets + 1, "{options:?}");
        }
        let plain = render(&context, &scene, PLAIN).stats;
        assert_eq!(plain.triangles, 2 * sheets * (sheets + 1));
    }
}

#[test]
fn random_stacks_are_the_same_bits_and_equal_the_oracle() {
    let context = Context::headless().unwrap();
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    for (levels, distinct) in [(LEVELS, true), (5, false)] {
        let outcome = runner(48).run(&stacks(levels, distinct), |stack| {
            let mut renderer = renderer.borrow_mut();
            let mut frame = |options| {
                let method = Method::DepthPeeling(options);
                renderer.render(&stack.scene(), &method).unwrap()
            };
            let plain = frame(PLAIN);
            for options in IMPROVED {
                let improved = frame(options);
                let same = improved.image == plain.image
                    && improved.stats.lost == plain.stats.lost
                    && improved.stats.stopped == Some(Reason::EmptyLayer);
                let error = Comparison::new(&improved.image, &stack.expected(), F32).unwrap();
                if !same || (distinct && error.over > 0) {
                    let stats = improved.stats;
                    return Err(TestCaseError::fail(format!("{options:?} {stats:?}")));
                }
            }
            Ok(())
        });
        stack::expect_none(outcome);
    }
}

#[test]
fn a_limit_and_a_ratio_leave_out_the_same_layers() {
    let context = Context::headless().unwrap();
    let stack = staircase();
    for options in IMPROVED {
        for peels in 1..=6 {
            let limited = |options| DepthPeelingOptions {
                maximum_number_of_peels: peels,
                ..options
            };
            let [plain, improved] =
                [PLAIN, options].map(|options| peel(&context, &stack, limited(options)));
            assert_eq!(over(&improved, &nearest(&stack, peels)), 0);
            assert!(improved.image == plain.image, "{peels} {options:?}");
            assert_eq!(
                (improved.stats.layers, improved.stats.lost),
                (plain.stats.layers, plain.stats.lost),
                "{peels} {options:?}"
            );
        }
        for occlusion_ratio in [0.2, 0.5, 0.75, 1.0] {
            let with_ratio = |options| DepthPeelingOptions {
                occlusion_ratio,
                ..options
            };
            let [plain, improved] =
                [PLAIN, options].map(|options| peel(&context, &stack, with_ratio(options)));
            assert!(improved.image == plain.image, "{occlusion_ratio}");
            let counts = |stats: &onionskin::Stats| (stats.layers, stats.lost, stats.stopped);
            assert_eq!(
                counts(&improved.stats),
                counts(&plain.stats),
                "{occlusion_ratio} {options:?}"
            );
        }
    }
}

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
        "the count of the last layer forgotten",
        DepthPeelingOptions {
            maximum_number_of_peels: 4,
            ..LATE
        },
        &[changed(
            vtk::QUERY.amended,
            steps! {
                drawTransparentObjects();
                peels = i + 1;
                if (i > 1) {
                    pixels = samples(PIXELS);
                    stop if (pixels == 0) because EmptyLayer;
                    composited = composited + pixels;
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

#[test]
fn what_does_not_go_together_is_refused_with_a_remedy() {
    let context = Context::headless().unwrap();
    let scene = staircase().scene();
    let error = |renderer: Renderer<'_>, options| {
        let mut renderer = renderer;
        let refused = renderer.render(&scene, &Method::DepthPeeling(options));
        refused.unwrap_err().to_string()
    };
    let renderer = || Renderer::new(&context, 3, 2).unwrap();
    let fixed = renderer().with_formats(Format::Rgba32F, Format::Depth24Stencil8);
    assert!(error(fixed, ALIVE).contains("choose a depth format with floats"));
    for options in [LATE, ALIVE, BOTH] {
        let kept = DepthPeelingOptions {
            compositing: Compositing::KeepLayers,
            ..options
        };
        assert!(error(renderer(), kept).contains("keeps no layers"));
        let printed = DepthPeelingOptions {
            reading: Reading::AsPrinted,
            maximum_number_of_peels: 4,
            ..options
        };
        assert!(error(renderer(), printed).contains("the paper without amendments"));
    }
    let classic = DepthPeelingOptions {
        depth_unit_0: onionskin::options::DepthUnit0::Classic,
        ..CULL
    };
    assert!(error(renderer(), classic).contains("let depth unit 0 be a sampler"));
    let by_inverse_w = renderer().with_inverse_w();
    assert!(error(by_inverse_w, CULL).contains("window-space depth"));
    let mut method = Method::DepthPeeling(PLAIN);
    let error = method.choose("improve", "late-qeury").unwrap_err();
    assert!(error.to_string().contains("late-query"), "{error}");
    method.choose("improve", "late-query,alive,cull").unwrap();
    assert_eq!(method, Method::DepthPeeling(ALL));
}

const D32F: Format = Format::Depth32FStencil8;

fn allocate(workspace: &mut impl onionskin::low_level::steps::Workspace, depth: Format) {
    let resources = [&stage::RESOURCES, &vtk::PEELING, &stage::ACCUMULATING];
    allocate_maps(workspace, &resources, Format::Rgba32F, depth).unwrap();
}

fn machine<'c>(context: &'c Context, scene: &Scene, depth: Format) -> GlMachine<'c> {
    let mut gl = GlMachine::new(context, scene.size).unwrap();
    allocate(&mut gl, depth);
    gl.set_geometry(Geometry::upload(context, scene, scene.size).unwrap());
    gl.begin_frame();
    gl
}

/// The listing, without an occlusion ratio.
fn on_the_fly(
    machine: &mut impl onionskin::low_level::steps::Machine,
    amendments: &[Amendment],
    peels: f64,
) -> Outcome {
    let variables = Variables::new()
        .with("num_passes", peels)
        .with("occlusion_ratio", 0.0)
        .with("window_area", 0.0);
    let units = &mut DepthUnits::new(machine);
    run(&vtk::ON_THE_FLY, amendments, variables, units).unwrap()
}
