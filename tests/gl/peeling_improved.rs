//! The improvements of depth peeling: a query that is read a peel late, peels of the pixels alone that are alive, and peels
//! without the triangles that are finished. The image is the same to the last bit, and what they cost and spare is counted.

use crate::kit::bounds::F32;
use crate::kit::render::example;
use crate::kit::stack::{self, LEVELS, Stack, runner, stacks};
use crate::kit::vtk_scenes::{nearest, over, peel, render, soup_scene, staircase};
use onionskin::generate::{Quads, Soup, SubmissionOrder, quads, soup};
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{Amendment, DepthUnits, Outcome, Reason, Variables, run};
use onionskin::options::{Compositing, DepthPeelingOptions, Reading};
use onionskin::{Camera, Comparison, Context, Format, Method, Renderer, Scene};
use proptest::test_runner::TestCaseError;

pub(crate) const PLAIN: DepthPeelingOptions = DepthPeelingOptions {
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
pub(crate) const LATE: DepthPeelingOptions = DepthPeelingOptions {
    late_query: true,
    ..PLAIN
};
pub(crate) const ALIVE: DepthPeelingOptions = DepthPeelingOptions {
    alive: true,
    ..PLAIN
};
pub(crate) const BOTH: DepthPeelingOptions = DepthPeelingOptions {
    late_query: true,
    ..ALIVE
};
pub(crate) const CULL: DepthPeelingOptions = DepthPeelingOptions {
    cull: true,
    ..PLAIN
};
pub(crate) const ALL: DepthPeelingOptions = DepthPeelingOptions { cull: true, ..BOTH };
pub(crate) const IMPROVED: [DepthPeelingOptions; 5] = [LATE, ALIVE, BOTH, CULL, ALL];

/// The staircase with and without something opaque, a soup, and a scene of meshes before an opaque plane.
pub(crate) fn scenes() -> Vec<Scene> {
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

pub(crate) const D32F: Format = Format::Depth32FStencil8;

pub(crate) fn allocate(workspace: &mut impl onionskin::low_level::steps::Workspace, depth: Format) {
    let resources = [&stage::RESOURCES, &vtk::PEELING, &stage::ACCUMULATING];
    allocate_maps(workspace, &resources, Format::Rgba32F, depth).unwrap();
}

pub(crate) fn machine<'c>(context: &'c Context, scene: &Scene, depth: Format) -> GlMachine<'c> {
    let mut gl = GlMachine::new(context, scene.size).unwrap();
    allocate(&mut gl, depth);
    gl.set_geometry(Geometry::upload(context, scene, scene.size).unwrap());
    gl.begin_frame();
    gl
}

/// The listing, without an occlusion ratio.
pub(crate) fn on_the_fly(
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
