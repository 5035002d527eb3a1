//! What VTK's depth peeling page claims, each claim under its key. V07 and V09 are in
//! `gl_claims_vtk_requirements.rs`, V08 in `gl_classic_fixed_function.rs`.

use onionskin::image::Comparison;
use onionskin::methods::{Compositing, DepthPeelingOptions, Frame, Peeling};
use onionskin::papers::vtk;
use onionskin::scene::generate::{Soup, soup};
use onionskin::steps::{Amendment, Map, Reason, Step, gl::*};
use onionskin::{Context, Method, Renderer, Scene, steps};

#[path = "common/stack.rs"]
#[allow(dead_code)]
mod stack;
use stack::{Piece, Stack};

/// f32 colours composited in at most 64 roundings of 2^-24 each, and the oracle's own rounding to f32: 4e-6. The issue
/// that asked for exactness allows 1e-5.
const F32: f64 = 1e-5;

const BOTH: [Compositing; 2] = [Compositing::OnTheFly, Compositing::KeepLayers];

#[test]
fn v01_the_loop_ends_after_the_maximum_number_of_peels() {
    let context = Context::headless().unwrap();
    let stack = staircase();
    for compositing in BOTH {
        for peels in 1..=3 {
            let stats = peel(&context, &stack, limited(peels, compositing)).stats;
            assert_eq!(
                (stats.iterations, stats.layers, stats.geometry_passes),
                (peels, Some(peels), u64::from(peels))
            );
            assert_eq!(stats.stopped, Some(Reason::PeelLimit));
        }
    }
}

#[test]
fn v01_the_image_of_n_peels_is_that_of_the_n_nearest_layers() {
    let context = Context::headless().unwrap();
    let stack = staircase();
    for compositing in BOTH {
        for peels in 1..=4 {
            let frame = peel(&context, &stack, limited(peels, compositing));
            assert_eq!(over(&frame, &nearest(&stack, peels)), 0, "{peels} peels");
        }
        let one = peel(&context, &stack, limited(1, compositing));
        assert!(over(&one, &nearest(&stack, 2)) > 0, "1 is not 2");
    }
}

#[test]
fn v01_what_the_limit_leaves_out_is_counted() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (peels, lost) in [(1, 7), (2, 3), (3, 1), (4, 0)] {
            let stats = peel(&context, &staircase(), limited(peels, compositing)).stats;
            assert_eq!((stats.fragments, stats.lost), (13, Some(lost)));
        }
    }
}

#[test]
fn v01_a_maximum_of_0_is_no_limit() {
    let context = Context::headless().unwrap();
    assert_eq!(DepthPeelingOptions::default().maximum_number_of_peels, 0);
    for compositing in BOTH {
        let frame = peel(&context, &staircase(), limited(0, compositing));
        assert_eq!(
            (frame.stats.layers, frame.stats.stopped),
            (Some(4), Some(Reason::EmptyLayer))
        );
        assert_eq!(over(&frame, &staircase()), 0);
    }
}

#[test]
fn v01_a_maximum_beyond_the_layers_there_are_changes_nothing() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let all = peel(&context, &staircase(), limited(0, compositing));
        let more = peel(&context, &staircase(), limited(1000, compositing));
        assert!(all.image == more.image);
        assert_eq!(
            (more.stats.layers, more.stats.iterations, more.stats.stopped),
            (Some(4), 5, Some(Reason::EmptyLayer))
        );
    }
}

#[test]
fn v01_a_maximum_of_just_the_layers_there_are_spares_the_empty_peel() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let frame = peel(&context, &staircase(), limited(4, compositing));
        assert_eq!(
            (
                frame.stats.iterations,
                frame.stats.lost,
                frame.stats.stopped
            ),
            (4, Some(0), Some(Reason::PeelLimit))
        );
        assert_eq!(over(&frame, &staircase()), 0);
    }
}

/// The staircase's layers have 6, 4, 2 and 1 of 6 pixels: which ratio ends the loop after which.
const RATIOS: [(f64, u32, Reason); 7] = [
    (0.0, 4, Reason::EmptyLayer),
    // 1 of 6 is not fewer than 1/6, but 0 of 6 are none at all.
    (1.0 / 6.0, 4, Reason::EmptyLayer),
    (0.2, 4, Reason::OcclusionRatio),
    // 2 of 6 are not fewer than 1/3, 1 of 6 is.
    (1.0 / 3.0, 4, Reason::OcclusionRatio),
    (0.5, 3, Reason::OcclusionRatio),
    (0.75, 2, Reason::OcclusionRatio),
    // The first layer covers everything, and all are not fewer than all.
    (1.0, 2, Reason::OcclusionRatio),
];

#[test]
fn v02_the_loop_stops_when_a_peel_changed_fewer_pixels_than_the_ratio() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (ratio, layers, reason) in RATIOS {
            let stats = peel(&context, &staircase(), with_ratio(ratio, compositing)).stats;
            assert_eq!(
                (stats.layers, stats.stopped),
                (Some(layers), Some(reason)),
                "ratio {ratio}, {compositing:?}"
            );
        }
    }
}

#[test]
fn v02_without_the_amendment_the_ratio_would_be_ignored() {
    // What the amendment puts in, less its condition.
    const NO_RATIO: &[Amendment] = &[changed(
        vtk::KEEP_DEPTH.amended,
        steps! {
            save color buffer RGBA as layer i;
            glCopyImageSubData(Map::at("depth buffer", "B"), Map::at("layer depth", "i"));
            num_layers = i + 1;
        },
    )];
    let context = Context::headless().unwrap();
    let options = DepthPeelingOptions {
        amendments: NO_RATIO,
        ..with_ratio(1.0, Compositing::KeepLayers)
    };
    let stats = peel(&context, &staircase(), options).stats;
    assert_eq!(
        (stats.layers, stats.stopped),
        (Some(4), Some(Reason::EmptyLayer))
    );
}

#[test]
fn v02_the_last_peel_is_composited() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (ratio, layers, _) in RATIOS {
            let frame = peel(&context, &staircase(), with_ratio(ratio, compositing));
            assert_eq!(
                over(&frame, &nearest(&staircase(), layers)),
                0,
                "ratio {ratio}"
            );
        }
    }
}

#[test]
fn v02_what_the_ratio_leaves_out_is_counted() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (ratio, lost) in [(0.0, 0), (0.2, 0), (0.5, 1), (0.75, 3), (1.0, 3)] {
            let stats = peel(&context, &staircase(), with_ratio(ratio, compositing)).stats;
            assert_eq!(stats.lost, Some(lost), "ratio {ratio}");
        }
    }
}

#[test]
fn v02_a_ratio_of_0_is_exact_and_the_default() {
    let context = Context::headless().unwrap();
    assert_eq!(DepthPeelingOptions::default().occlusion_ratio, 0.0);
    for compositing in BOTH {
        let frame = peel(&context, &staircase(), with_ratio(0.0, compositing));
        assert_eq!((frame.stats.lost, over(&frame, &staircase())), (Some(0), 0));
    }
}

#[test]
fn v02_a_larger_ratio_needs_no_more_peels() {
    // "A ratio of 0.2 will render faster than a ratio of 0.1."
    let context = Context::headless().unwrap();
    let scene = soup_scene();
    for compositing in BOTH {
        let passes: Vec<_> = [0.0, 0.1, 0.2]
            .map(|ratio| {
                let options = with_ratio(ratio, compositing);
                render(&context, &scene, options).stats.geometry_passes
            })
            .to_vec();
        assert!(passes[0] > passes[1] && passes[1] > passes[2], "{passes:?}");
    }
}

#[test]
fn v02_pixels_are_counted_and_not_the_fragments_that_changed_them() {
    // One pixel of six has its ten fragments submitted back to front, so that each lowers the depth in the first peel:
    // ten samples, one pixel.
    let context = Context::headless().unwrap();
    let mut pixels = vec![vec![]; 6];
    pixels[2] = (0..10).map(|n| piece(900 - n * 50)).collect();
    let stack = Stack {
        width: 3,
        pixels,
        opaque: None,
    };
    for compositing in BOTH {
        let stats = peel(&context, &stack, with_ratio(0.5, compositing)).stats;
        assert_eq!(
            (stats.layers, stats.stopped),
            (Some(1), Some(Reason::OcclusionRatio))
        );
    }
}

#[test]
fn v02_a_ratio_that_is_none_is_refused() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 3, 2).unwrap();
    for ratio in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        let method = Method::DepthPeeling(with_ratio(ratio, Compositing::OnTheFly));
        let error = renderer.render(&staircase().scene(), &method).unwrap_err();
        assert!(error.to_string().contains("occlusion ratio"), "{error}");
    }
}

#[test]
fn v03_opaque_geometry_culls_what_lies_behind_it_and_lowers_the_number_of_layers() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        // Layers at 100, 200, 300 and 400.
        let layers: Vec<_> = [None, Some(450), Some(350), Some(200), Some(50)]
            .map(|opaque| {
                let stack = Stack {
                    opaque,
                    ..staircase()
                };
                let frame = peel(&context, &stack, limited(0, compositing));
                assert_eq!(over(&frame, &stack), 0, "opaque at {opaque:?}");
                frame.stats.layers.unwrap()
            })
            .to_vec();
        assert_eq!(layers, [4, 4, 3, 1, 0]);
    }
}

#[test]
fn v03_what_is_culled_makes_no_pass() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let passes = |opaque| {
            let stack = Stack {
                opaque,
                ..staircase()
            };
            peel(&context, &stack, limited(0, compositing))
                .stats
                .geometry_passes
        };
        assert_eq!(
            (passes(None), passes(Some(250)), passes(Some(50))),
            (5, 3, 1)
        );
    }
}

#[test]
fn v03_without_the_amendment_the_number_of_layers_is_not_lowered() {
    const NOT_CULLED: &[Amendment] = &[changed(
        vtk::CULL_BY_OPAQUE.amended,
        vtk::CULL_BY_OPAQUE.printed,
    )];
    let context = Context::headless().unwrap();
    let stack = Stack {
        opaque: Some(250),
        ..staircase()
    };
    for compositing in BOTH {
        let layers = |amendments| {
            let options = DepthPeelingOptions {
                amendments,
                ..limited(0, compositing)
            };
            peel(&context, &stack, options).stats.layers
        };
        assert_eq!((layers(&[]), layers(NOT_CULLED)), (Some(2), Some(4)));
    }
}

#[test]
fn v04_the_empty_layer_ends_the_loop() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for layers in 0..=4 {
            let stats = peel(
                &context,
                &nearest(&staircase(), layers),
                limited(0, compositing),
            )
            .stats;
            assert_eq!(
                (stats.iterations, stats.layers, stats.stopped),
                (layers + 1, Some(layers), Some(Reason::EmptyLayer))
            );
        }
    }
}

#[test]
fn v04_without_the_query_the_loop_would_not_end() {
    const NO_QUERY: &[Amendment] = &[changed(
        vtk::QUERY.amended,
        steps! {
            drawTransparentObjects();
            peels = i + 1;
        },
    )];
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let options = DepthPeelingOptions {
            amendments: NO_QUERY,
            ..limited(9, compositing)
        };
        let stats = peel(&context, &staircase(), options).stats;
        assert_eq!(
            (stats.iterations, stats.stopped),
            (9, Some(Reason::PeelLimit))
        );
    }
}

#[test]
fn v05_a_frame_says_that_depth_peeling_was_used() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let stats = peel(&context, &staircase(), limited(0, compositing)).stats;
        assert_eq!(stats.peeling, Peeling::Used);
        assert!(
            stats.to_string().contains("depth peeling    used"),
            "{stats}"
        );
    }
}

#[test]
fn v05_a_frame_without_anything_transparent_says_why_it_was_not() {
    let context = Context::headless().unwrap();
    let mut scene = Stack {
        opaque: Some(500),
        ..staircase()
    }
    .scene();
    scene.meshes.truncate(1);
    for compositing in BOTH {
        let stats = render(&context, &scene, limited(0, compositing)).stats;
        assert_eq!(stats.peeling, Peeling::NothingTransparent);
        assert_eq!(
            stats.peeling.to_string(),
            "not used: nothing is transparent"
        );
    }
}

#[test]
fn v05_a_frame_of_another_method_says_why_it_was_not() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 3, 2).unwrap();
    for method in [Method::Blend, Method::Painter, Method::Exact] {
        let stats = renderer
            .render(&staircase().scene(), &method)
            .unwrap()
            .stats;
        assert_eq!(stats.peeling, Peeling::OtherMethod);
        assert_eq!(stats.peeling.to_string(), "not used: another method");
    }
}

#[test]
fn v06_both_ways_of_compositing_give_the_same_image() {
    let context = Context::headless().unwrap();
    let scenes = [soup_scene(), staircase().scene(), teapot_scene()];
    for scene in scenes {
        let [on_the_fly, kept] = BOTH.map(|way| render(&context, &scene, limited(0, way)));
        assert_eq!(on_the_fly.stats.layers, kept.stats.layers);
        let error = Comparison::new(&on_the_fly.image, &kept.image, 0.0).unwrap();
        // Each way rounds values up to 1 at most four times a layer, to 2^-25 at worst, and twice at the end.
        let layers = f64::from(kept.stats.layers.unwrap());
        let bound = 2.0 * (4.0 * layers + 2.0) * 2.0_f64.powi(-25);
        println!("{}: {} of at most {bound}", scene.name, error.max);
        assert!(error.max <= bound, "{}: {error:?}", scene.name);
    }
}

#[test]
fn v06_compositing_over_instead_of_under_would_be_noticed() {
    // Everitt's blending function, but front to back.
    const OVER: &[Amendment] = &[changed(
        steps! { glBlendFuncSeparate(ONE_MINUS_DST_ALPHA, ONE, ONE_MINUS_DST_ALPHA, ONE); },
        steps! { glBlendFuncSeparate(ONE, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA); },
    )];
    let context = Context::headless().unwrap();
    let options = DepthPeelingOptions {
        amendments: OVER,
        ..limited(0, Compositing::OnTheFly)
    };
    let frame = peel(&context, &staircase(), options);
    // The four pixels with more than one layer.
    assert_eq!(over(&frame, &staircase()), 4);
}

#[test]
fn v06_kept_layers_take_memory_by_their_number() {
    let context = Context::headless().unwrap();
    let bytes: Vec<_> = (1..=4)
        .map(|peels| {
            peel(
                &context,
                &staircase(),
                limited(peels, Compositing::KeepLayers),
            )
            .stats
            .bytes
        })
        .collect();
    // RGBA32F is 16 bytes a pixel, DEPTH32F_STENCIL8 is 8; 6 pixels.
    let a_layer = 6 * (16 + 8);
    for pair in bytes.windows(2) {
        assert_eq!(pair[1] - pair[0], a_layer, "{bytes:?}");
    }
}

#[test]
fn v06_compositing_on_the_fly_takes_the_same_memory_for_any_number_of_layers() {
    let context = Context::headless().unwrap();
    let bytes: Vec<_> = (1..=4)
        .map(|peels| {
            peel(
                &context,
                &staircase(),
                limited(peels, Compositing::OnTheFly),
            )
            .stats
            .bytes
        })
        .collect();
    assert!(bytes.windows(2).all(|pair| pair[0] == pair[1]), "{bytes:?}");
}

/// Six pixels with 4, 3, 2, 2, 1 and 1 fragments, so that the layers have 6, 4, 2 and 1 pixels; at levels 100, 200,
/// 300 and 400, submitted back to front.
fn staircase() -> Stack {
    let pixels =
        [4, 3, 2, 2, 1, 1].map(|count| (1..=count).rev().map(|n| piece(n * 100)).collect());
    Stack {
        width: 3,
        pixels: pixels.to_vec(),
        opaque: None,
    }
}

fn piece(level: u16) -> Piece {
    Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    }
}

/// The stack with the first `count` levels of each pixel.
fn nearest(stack: &Stack, count: u32) -> Stack {
    let mut kept = stack.clone();
    for pieces in &mut kept.pixels {
        pieces.sort_by_key(|piece| piece.level);
        pieces.truncate(count as usize);
    }
    kept
}

fn soup_scene() -> Scene {
    let mut scene = Scene::of("soup", vec![soup(&Soup::default()).unwrap()]);
    scene.size = [120, 90];
    scene
}

fn teapot_scene() -> Scene {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/teapot.toml");
    Scene::load_at(path, Some([120, 90])).unwrap()
}

fn limited(peels: u32, compositing: Compositing) -> DepthPeelingOptions {
    DepthPeelingOptions {
        maximum_number_of_peels: peels,
        compositing,
        ..Default::default()
    }
}

fn with_ratio(occlusion_ratio: f64, compositing: Compositing) -> DepthPeelingOptions {
    DepthPeelingOptions {
        occlusion_ratio,
        compositing,
        ..Default::default()
    }
}

fn render(context: &Context, scene: &Scene, options: DepthPeelingOptions) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer
        .render(scene, &Method::DepthPeeling(options))
        .unwrap()
}

fn peel(context: &Context, stack: &Stack, options: DepthPeelingOptions) -> Frame {
    render(context, &stack.scene(), options)
}

/// How many pixels of the frame are not the stack's.
fn over(frame: &Frame, stack: &Stack) -> usize {
    Comparison::new(&frame.image, &stack.expected(), F32)
        .unwrap()
        .over
}

const fn changed(printed: &'static [Step], amended: &'static [Step]) -> Amendment {
    Amendment {
        key: "",
        place: "",
        printed,
        amended,
        why: "to see whether it is noticed",
        test: "",
    }
}
