//! Dual depth peeling against the oracle, its number of passes, and every way to stop.

use crate::kit::bounds::F32;
use crate::kit::driver::settled;
use crate::kit::render::render;
use crate::kit::stack;
use onionskin::generate::{Soup, soup};
use onionskin::low_level::methods::Peeling;
use onionskin::low_level::steps::{Amendment, Reason, gl::*};
use onionskin::options::{DepthPeelingOptions, DualDepthPeelingOptions};
use onionskin::{Comparison, Context, Format, Frame, Method, Renderer, Scene, steps};
use proptest::test_runner::TestCaseError;

use crate::kit::changed::changed;
use crate::kit::stack::{Piece, Stack, runner, stacks};

#[test]
fn random_stacks_with_and_without_ties_equal_the_oracle() {
    for (levels, distinct) in [(stack::LEVELS, true), (5, false)] {
        check_stacks(levels, distinct, 96);
    }
}

#[test]
fn soups_and_real_meshes_equal_the_exact_image() {
    let context = Context::headless().unwrap();
    let soups = (0..4).map(soup_scene);
    for scene in soups.chain(["teapot", "knots", "molecule"].map(example)) {
        let exact = render(&context, &scene, &Method::Exact);
        let dual = peel(&context, &scene, DualDepthPeelingOptions::default());
        let image = settled(&context, &dual, &exact);
        let error = Comparison::new(&image, &exact.image, F32).unwrap();
        assert_eq!(error.over, 0, "{}: {error:?}\n{}", scene.name, dual.stats);
        assert_eq!(dual.stats.lost, Some(0));
    }
}

#[test]
fn n_layers_take_half_of_n_plus_one_passes() {
    let context = Context::headless().unwrap();
    for layers in 0..=9_u16 {
        // The other pixels have fewer layers; the deepest decides.
        let pixels = [layers, layers / 2, 0, 1.min(layers), layers, layers]
            .map(|count| (0..count).map(|n| piece(900 - n * 70)).collect());
        let stack = Stack {
            width: 3,
            pixels: pixels.to_vec(),
            opaque: None,
        };
        let frame = peel(&context, &stack.scene(), DualDepthPeelingOptions::default());
        assert_eq!(over(&frame, &stack), 0, "{layers} layers");
        let peels = layers.div_ceil(2);
        assert_eq!(
            (frame.stats.iterations, frame.stats.geometry_passes),
            (u32::from(peels), u64::from(peels) + 1),
            "{layers} layers"
        );
        assert_eq!(frame.stats.stopped, Some(Reason::EmptyLayer));
    }
}

#[test]
fn real_scenes_take_half_the_passes_of_single_peeling_plus_one() {
    let context = Context::headless().unwrap();
    for scene in ["teapot", "knots", "molecule"].map(example) {
        let single = Method::DepthPeeling(DepthPeelingOptions::default());
        let layers = render(&context, &scene, &single).stats.layers.unwrap();
        let dual = peel(&context, &scene, DualDepthPeelingOptions::default()).stats;
        assert_eq!(dual.geometry_passes, u64::from(layers.div_ceil(2)) + 1);
    }
}

#[test]
fn a_limit_of_k_peels_leaves_out_the_middle_and_counts_it() {
    let context = Context::headless().unwrap();
    let levels = [700, 100, 300, 900, 500, 200, 800];
    let stack = |levels: &[u16]| Stack {
        width: 3,
        pixels: vec![levels.iter().map(|&level| piece(level)).collect(); 6],
        opaque: None,
    };
    let all = stack(&levels);
    for (peels, kept, left) in [
        (1, vec![100, 900], 30),
        (2, vec![100, 200, 800, 900], 18),
        (3, vec![100, 200, 300, 700, 800, 900], 6),
        (4, levels.to_vec(), 0),
        (9, levels.to_vec(), 0),
    ] {
        let options = DualDepthPeelingOptions {
            maximum_number_of_peels: peels,
            ..Default::default()
        };
        let frame = peel(&context, &all.scene(), options);
        assert_eq!(over(&frame, &stack(&kept)), 0, "{peels} peels");
        assert_eq!(frame.stats.lost, Some(left), "{peels} peels");
        // What counts the rest is no pass of the method.
        assert_eq!(frame.stats.geometry_passes, u64::from(peels.min(4)) + 1);
        let reason = if left == 0 {
            Reason::EmptyLayer
        } else {
            Reason::PeelLimit
        };
        assert_eq!(frame.stats.stopped, Some(reason));
    }
}

#[test]
fn the_loop_stops_after_a_peel_that_changed_fewer_pixels_than_the_ratio() {
    let context = Context::headless().unwrap();
    // Peels change 6, 3, 1 of 6 pixels.
    let pixels = [6, 4, 3, 2, 2, 1].map(|count: u16| (1..=count).map(|n| piece(n * 100)).collect());
    let stack = Stack {
        width: 3,
        pixels: pixels.to_vec(),
        opaque: None,
    };
    for (ratio, peels, reason, lost) in [
        (0.0, 3, Reason::EmptyLayer, 0),
        (0.5, 3, Reason::EmptyLayer, 0),
        (0.6, 2, Reason::OcclusionRatio, 2),
        (1.0, 2, Reason::OcclusionRatio, 2),
    ] {
        let options = DualDepthPeelingOptions {
            occlusion_ratio: ratio,
            ..Default::default()
        };
        let stats = peel(&context, &stack.scene(), options).stats;
        assert_eq!(
            (stats.iterations, stats.stopped, stats.lost),
            (peels, Some(reason), Some(lost)),
            "ratio {ratio}"
        );
    }
}

#[test]
fn a_ratio_that_is_none_is_refused() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 3, 2).unwrap();
    for occlusion_ratio in [-0.1, 1.1, f64::NAN] {
        let method = Method::DualDepthPeeling(DualDepthPeelingOptions {
            occlusion_ratio,
            ..Default::default()
        });
        let error = renderer.render(&soup_scene(0), &method).unwrap_err();
        assert!(error.to_string().contains("occlusion ratio"), "{error}");
    }
}

#[test]
fn nothing_transparent_and_nothing_in_view_end_at_once() {
    let context = Context::headless().unwrap();
    let stack = Stack {
        width: 3,
        pixels: vec![vec![piece(300)]; 6],
        opaque: Some(500),
    };
    let mut opaque = stack.scene();
    opaque.meshes.truncate(1);
    let stats = peel(&context, &opaque, DualDepthPeelingOptions::default()).stats;
    assert_eq!(
        (stats.peeling, stats.geometry_passes, stats.lost),
        (Peeling::NothingTransparent, 0, Some(0))
    );
    let mut behind = stack.scene();
    for vertex in &mut behind.meshes[1].vertices {
        vertex.position.z = -vertex.position.z;
    }
    let stats = peel(&context, &behind, DualDepthPeelingOptions::default()).stats;
    assert_eq!(
        (stats.iterations, stats.geometry_passes, stats.lost),
        (0, 1, Some(0))
    );
}

#[test]
fn shuffled_triangles_give_the_same_image_bit_for_bit() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(0);
    let mut shuffled = scene.clone();
    shuffled.meshes[0] = shuffled.meshes[0].shuffled(100);
    let [a, b] =
        [&scene, &shuffled].map(|scene| peel(&context, scene, DualDepthPeelingOptions::default()));
    assert!(a.image == b.image);
}

#[test]
fn a_fixed_point_depth_buffer_does_it_no_harm() {
    // Its own depths are floats; single peeling on D24 is another matter (`gl/invariance.rs`).
    let context = Context::headless().unwrap();
    let scene = soup_scene(3);
    let [width, height] = scene.size;
    let exact = render(&context, &scene, &Method::Exact);
    let mut renderer = Renderer::new(&context, width, height)
        .unwrap()
        .with_formats(Format::Rgba32F, Format::Depth24Stencil8);
    let method = Method::DualDepthPeeling(DualDepthPeelingOptions::default());
    let dual = renderer.render(&scene, &method).unwrap();
    let error = Comparison::new(&dual.image, &exact.image, F32).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

#[test]
pub(crate) fn vx03_blending_colors_by_max_merges_what_is_coplanar() {
    // As published: one blend equation for all draw buffers.
    const MAX_FOR_ALL: &[Amendment] = &[changed(
        steps! { glBlendFunci(2, ONE_MINUS_DST_ALPHA, ONE); },
        steps! { glBlendEquationi(2, MAX); },
    )];
    let context = Context::headless().unwrap();
    let of = |level, [r, g, b]: [f32; 3]| Piece {
        level,
        color: [r, g, b, 0.5],
    };
    // Red and green at one depth, behind something that lets everything through.
    let clear = Piece {
        level: 10,
        color: [0.0; 4],
    };
    let list = vec![clear, of(500, [1.0, 0.0, 0.0]), of(500, [0.0, 1.0, 0.0])];
    let stack = Stack {
        width: 3,
        pixels: vec![list; 6],
        opaque: None,
    };
    let image = |amendments| {
        let options = DualDepthPeelingOptions {
            amendments,
            ..Default::default()
        };
        peel(&context, &stack.scene(), options).image.pixels[0]
    };
    let background = [0.9, 0.8, 0.7_f32];
    // Red in front of green: a half and a quarter. Merged: a half each.
    let exact = [0.5, 0.25, 0.0].map(f64::from);
    let merged = [0.5, 0.5, 0.0].map(f64::from);
    for (found, expected, light) in [(image(&[]), exact, 0.25), (image(MAX_FOR_ALL), merged, 0.5)] {
        let found = found.to_array();
        for channel in 0..3 {
            let whole = expected[channel] + light * f64::from(background[channel]);
            assert!((f64::from(found[channel]) - whole).abs() < F32, "{found:?}");
        }
    }
}

#[test]
fn a_listing_with_one_changed_word_gives_another_image() {
    let context = Context::headless().unwrap();
    let levels = [700, 100, 900, 300, 500];
    let stack = Stack {
        width: 3,
        pixels: vec![levels.map(piece).to_vec(); 6],
        opaque: Some(800),
    };
    for (name, change) in CHANGES {
        let options = DualDepthPeelingOptions {
            maximum_number_of_peels: 12,
            amendments: change,
            ..Default::default()
        };
        let frame = peel(&context, &stack.scene(), options);
        assert!(over(&frame, &stack) > 0, "{name} was not noticed");
    }
}

const CHANGES: &[(&str, &[Amendment])] = &[
    (
        "the depths not started anew",
        &[changed(
            steps! { glClearBufferfv(0, [-2.0; 4]); glClearBufferfv(2, [0.0; 4]); },
            steps! { glClearBufferfv(2, [0.0; 4]); },
        )],
    ),
    (
        "the farthest not started anew",
        &[changed(steps! { glClearBufferfv(2, [0.0; 4]); }, steps! {})],
    ),
    (
        "the front over what is there",
        &[changed(
            steps! { glBlendFunci(1, ONE_MINUS_DST_ALPHA, ONE); },
            steps! { glBlendFunci(1, ONE, ONE_MINUS_SRC_ALPHA); },
        )],
    ),
    (
        "the back under what is there",
        &[changed(
            steps! {
                glBlendFunci(0, ONE, ONE_MINUS_SRC_ALPHA);
                glUseProgram(onionskin::low_level::papers::stage::LAYER);
                glActiveTexture(2);
                glBindTexture(onionskin::low_level::papers::bavoil_2008::FARTHEST);
            },
            steps! {
                glBlendFunci(0, ONE_MINUS_DST_ALPHA, ONE);
                glUseProgram(onionskin::low_level::papers::stage::LAYER);
                glActiveTexture(2);
                glBindTexture(onionskin::low_level::papers::bavoil_2008::FARTHEST);
            },
        )],
    ),
    (
        "A for B",
        &[changed(steps! { B = (i + 1) % 2; }, steps! { B = i % 2; })],
    ),
];

fn piece(level: u16) -> Piece {
    Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    }
}

fn soup_scene(seed: u64) -> Scene {
    let mesh = soup(&Soup {
        triangle_size: [0.5, 1.5],
        seed,
        count: 300,
        ..Soup::default()
    });
    let mut scene = Scene::of("soup", vec![mesh.unwrap()]);
    scene.size = [160, 120];
    scene
}

fn example(name: &str) -> Scene {
    crate::kit::render::example(name, [120, 90])
}

fn peel(context: &Context, scene: &Scene, options: DualDepthPeelingOptions) -> Frame {
    render(context, scene, &Method::DualDepthPeeling(options))
}

/// How many pixels of the frame are not the stack's.
fn over(frame: &Frame, stack: &Stack) -> usize {
    let error = Comparison::new(&frame.image, &stack.expected(), F32);
    error.unwrap().over
}

/// Renders random stacks and judges them. A failure prints the smallest stack as fragment lists.
fn check_stacks(levels: u16, distinct: bool, cases: u32) {
    let context = Context::headless().unwrap();
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    let method = Method::DualDepthPeeling(DualDepthPeelingOptions::default());
    let outcome = runner(cases).run(&stacks(levels, distinct), |stack| {
        let frame = renderer
            .borrow_mut()
            .render(&stack.scene(), &method)
            .unwrap();
        let (fragments, _) = stack.counts();
        let right = over(&frame, &stack) == 0
            && frame.stats.fragments == fragments
            && frame.stats.lost == Some(0);
        right
            .then_some(())
            .ok_or_else(|| TestCaseError::fail(format!("{:?}", frame.stats)))
    });
    stack::expect_none(outcome);
}
