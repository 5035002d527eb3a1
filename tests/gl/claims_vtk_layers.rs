//! What VTK's depth peeling page claims of opaque geometry, of the empty layer, of what a frame says and of kept layers
//! (V03 to V06), each claim under its key.

use crate::kit::changed::changed;
use crate::kit::stack::Stack;
use crate::kit::vtk_scenes::{BOTH, limited, nearest, over, peel, render, soup_scene, staircase};
use onionskin::low_level::methods::Peeling;
use onionskin::low_level::papers::vtk;
use onionskin::low_level::steps::{Amendment, Reason, gl::*};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Comparison, Context, Method, Renderer, Scene, steps};

#[test]
pub(crate) fn v03_opaque_geometry_culls_what_lies_behind_it_and_lowers_the_number_of_layers() {
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
pub(crate) fn v03_what_is_culled_makes_no_pass() {
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
pub(crate) fn v03_without_the_amendment_the_number_of_layers_is_not_lowered() {
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
pub(crate) fn v04_the_empty_layer_ends_the_loop() {
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
pub(crate) fn v04_without_the_query_the_loop_would_not_end() {
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
pub(crate) fn v05_a_frame_says_that_depth_peeling_was_used() {
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
pub(crate) fn v05_a_frame_without_anything_transparent_says_why_it_was_not() {
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
pub(crate) fn v05_a_frame_of_another_method_says_why_it_was_not() {
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
pub(crate) fn v06_both_ways_of_compositing_give_the_same_image() {
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
pub(crate) fn v06_compositing_over_instead_of_under_would_be_noticed() {
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
pub(crate) fn v06_kept_layers_take_memory_by_their_number() {
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
pub(crate) fn v06_compositing_on_the_fly_takes_the_same_memory_for_any_number_of_layers() {
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

fn teapot_scene() -> Scene {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/teapot.toml");
    Scene::load_at(path, Some([120, 90])).unwrap()
}
