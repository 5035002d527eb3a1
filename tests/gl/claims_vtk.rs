//! What VTK's depth peeling page claims of the two ways to stop early (V01, V02), each claim under its key. V03 to V06 are
//! in `gl/claims_vtk_layers.rs`, V07 and V09 in `gl/claims_vtk_requirements.rs`, V08 in `gl/classic_fixed_function.rs`.

use crate::kit::changed::changed;
use crate::kit::stack::Stack;
use crate::kit::vtk_scenes::{
    BOTH, limited, nearest, over, peel, piece, render, soup_scene, staircase,
};
use onionskin::low_level::papers::vtk;
use onionskin::low_level::steps::{Amendment, Map, Reason};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Context, Method, Renderer, steps};

#[test]
pub(crate) fn v01_the_loop_ends_after_the_maximum_number_of_peels() {
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
pub(crate) fn v01_the_image_of_n_peels_is_that_of_the_n_nearest_layers() {
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
pub(crate) fn v01_what_the_limit_leaves_out_is_counted() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (peels, lost) in [(1, 7), (2, 3), (3, 1), (4, 0)] {
            let stats = peel(&context, &staircase(), limited(peels, compositing)).stats;
            assert_eq!((stats.fragments, stats.lost), (13, Some(lost)));
        }
    }
}

#[test]
pub(crate) fn v01_a_maximum_of_0_is_no_limit() {
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
pub(crate) fn v02_the_loop_stops_when_a_peel_changed_fewer_pixels_than_the_ratio() {
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
pub(crate) fn v02_without_the_amendment_the_ratio_would_be_ignored() {
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
pub(crate) fn v02_what_the_ratio_leaves_out_is_counted() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        for (ratio, lost) in [(0.0, 0), (0.2, 0), (0.5, 1), (0.75, 3), (1.0, 3)] {
            let stats = peel(&context, &staircase(), with_ratio(ratio, compositing)).stats;
            assert_eq!(stats.lost, Some(lost), "ratio {ratio}");
        }
    }
}

#[test]
pub(crate) fn v02_a_ratio_of_0_is_exact_and_the_default() {
    let context = Context::headless().unwrap();
    assert_eq!(DepthPeelingOptions::default().occlusion_ratio, 0.0);
    for compositing in BOTH {
        let frame = peel(&context, &staircase(), with_ratio(0.0, compositing));
        assert_eq!((frame.stats.lost, over(&frame, &staircase())), (Some(0), 0));
    }
}

#[test]
pub(crate) fn v02_a_larger_ratio_needs_no_more_peels() {
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
pub(crate) fn v02_pixels_are_counted_and_not_the_fragments_that_changed_them() {
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
    let end = |amendments, compositing| {
        let options = DepthPeelingOptions {
            amendments,
            ..with_ratio(0.5, compositing)
        };
        let stats = peel(&context, &stack, options).stats;
        (stats.layers, stats.stopped)
    };
    for compositing in BOTH {
        let first = (Some(1), Some(Reason::OcclusionRatio));
        assert_eq!(end(&[], compositing), first);
    }
    // The peel's own query: ten are not fewer than half of six, and nine are not, ... but two are.
    const FRAGMENTS: &[Amendment] = &[changed(
        vtk::KEEP_DEPTH.amended,
        steps! {
            save color buffer RGBA as layer i;
            glCopyImageSubData(Map::at("depth buffer", "B"), Map::at("layer depth", "i"));
            num_layers = i + 1;
            stop if (peeled < (occlusion_ratio * window_area)) because OcclusionRatio;
        },
    )];
    let ninth = (Some(9), Some(Reason::OcclusionRatio));
    assert_eq!(end(FRAGMENTS, Compositing::KeepLayers), ninth);
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

fn with_ratio(occlusion_ratio: f64, compositing: Compositing) -> DepthPeelingOptions {
    DepthPeelingOptions {
        occlusion_ratio,
        compositing,
        ..Default::default()
    }
}
