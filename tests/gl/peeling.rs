//! Depth peeling against the oracle: random fragment stacks, random triangle soups, every way to stop.

use crate::kit::bounds::F32;
use crate::kit::driver::settled;
use crate::kit::stack;
use onionskin::generate::{Soup, soup};
use onionskin::low_level::methods::Peeling;
use onionskin::low_level::steps::Reason;
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Comparison, Context, Frame, Method, Renderer, Scene};
use proptest::test_runner::TestCaseError;

use crate::kit::peeling::peel;
use crate::kit::stack::{Piece, Stack, runner, stacks};

const BOTH: [Compositing; 2] = [Compositing::OnTheFly, Compositing::KeepLayers];

#[test]
fn random_stacks_without_ties_equal_the_oracle() {
    check_stacks(stacks(stack::LEVELS, true), 96, |stack, frame| {
        let (fragments, _) = stack.counts();
        let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
        (error.over == 0 && frame.stats.fragments == fragments && frame.stats.lost == Some(0))
            .then_some(())
            .ok_or(format!("{error:?} {:?}", frame.stats))
    });
}

#[test]
fn of_ties_the_first_submitted_is_kept_and_the_others_are_counted() {
    check_stacks(stacks(5, false), 96, |stack, frame| {
        let (fragments, ties) = stack.counts();
        let mut without = stack.clone();
        for pieces in &mut without.pixels {
            let mut seen = std::collections::HashSet::new();
            pieces.retain(|piece| seen.insert(piece.level));
        }
        let error = Comparison::new(&frame.image, &without.expected(), F32).unwrap();
        (error.over == 0 && frame.stats.fragments == fragments && frame.stats.lost == Some(ties))
            .then_some(())
            .ok_or(format!("{ties} ties, {error:?} {:?}", frame.stats))
    });
}

#[test]
fn a_wrong_image_would_be_noticed() {
    let context = Context::headless().unwrap();
    let mut stack = two_layers(None);
    let frame = peel(&context, &stack.scene(), DepthPeelingOptions::default());
    // One step of 8 bits in one channel of one fragment.
    stack.pixels[3][0].color[1] += 1.0 / 255.0;
    assert_eq!(
        Comparison::new(&frame.image, &stack.expected(), F32)
            .unwrap()
            .over,
        1
    );
}

#[test]
fn random_soups_equal_the_exact_image() {
    let context = Context::headless().unwrap();
    for seed in 0..6 {
        let scene = soup_scene(seed);
        let exact = Renderer::new(&context, 160, 120)
            .unwrap()
            .render(&scene, &Method::Exact)
            .unwrap();
        for compositing in BOTH {
            let frame = peel(
                &context,
                &scene,
                DepthPeelingOptions {
                    compositing,
                    ..Default::default()
                },
            );
            let image = settled(&context, &frame, &exact);
            let error = Comparison::new(&image, &exact.image, F32).unwrap();
            // A soup may have a tie by chance; then as many pixels may be off as fragments were lost.
            assert!(
                error.over as u64 <= frame.stats.lost.unwrap(),
                "seed {seed}: {error:?}\n{}",
                frame.stats
            );
            assert!(
                frame.stats.lost.unwrap() <= 2,
                "seed {seed}\n{}",
                frame.stats
            );
            assert!(
                frame.stats.fragments > 5_000,
                "seed {seed}: too thin a soup: {}",
                frame.stats.fragments
            );
        }
    }
}

#[test]
fn shuffled_triangles_give_the_same_image_bit_for_bit() {
    let context = Context::headless().unwrap();
    for seed in 0..4 {
        let scene = soup_scene(seed);
        let straight = peel(&context, &scene, DepthPeelingOptions::default());
        let mut shuffled = scene.clone();
        shuffled.meshes[0] = shuffled.meshes[0].shuffled(seed + 100);
        assert_ne!(shuffled.meshes[0].triangles, scene.meshes[0].triangles);
        let shuffled = peel(&context, &shuffled, DepthPeelingOptions::default());
        assert_eq!(
            straight.stats.lost,
            Some(0),
            "a tie would be broken by the order: choose another seed"
        );
        assert!(straight.image == shuffled.image, "seed {seed}");
        let blended = |scene| {
            Renderer::new(&context, 160, 120)
                .unwrap()
                .render(scene, &Method::Blend)
                .unwrap()
                .image
        };
        let mut other = scene.clone();
        other.meshes[0] = other.meshes[0].shuffled(seed + 100);
        assert!(
            blended(&scene) != blended(&other),
            "blending would have been changed by it"
        );
    }
}

#[test]
pub(crate) fn every_pixel_of_a_layer_is_counted_once() {
    let context = Context::headless().unwrap();
    for compositing in BOTH {
        let frame = peel(
            &context,
            &soup_scene(7),
            DepthPeelingOptions {
                compositing,
                ..Default::default()
            },
        );
        assert_eq!(frame.stats.lost, Some(0));
        if compositing == Compositing::KeepLayers {
            let depths = frame.layers.iter().flat_map(|layer| &layer.depth);
            assert_eq!(
                depths.filter(|&&depth| depth < 1.0).count() as u64,
                frame.stats.fragments
            );
        }
    }
}

#[test]
fn nothing_transparent_is_not_peeled() {
    let context = Context::headless().unwrap();
    let empty = Stack {
        width: 3,
        pixels: vec![vec![]; 6],
        opaque: Some(500),
    };
    let mut scene = empty.scene();
    scene.meshes.truncate(1);
    let frame = peel(&context, &scene, DepthPeelingOptions::default());
    assert_eq!(frame.stats.peeling, Peeling::NothingTransparent);
    assert_eq!(
        (
            frame.stats.geometry_passes,
            frame.stats.fragments,
            frame.stats.lost
        ),
        (0, 0, Some(0))
    );
    assert!(frame.image == empty.expected());
}

#[test]
fn a_transparent_mesh_that_is_not_in_view_is_one_empty_peel() {
    let context = Context::headless().unwrap();
    let mut scene = two_layers(None).scene();
    for vertex in &mut scene.meshes[0].vertices {
        vertex.position.z = -vertex.position.z;
    }
    let frame = peel(&context, &scene, DepthPeelingOptions::default());
    assert_eq!(
        (
            frame.stats.iterations,
            frame.stats.layers,
            frame.stats.fragments
        ),
        (1, Some(0), 0)
    );
    assert_eq!(frame.stats.stopped, Some(Reason::EmptyLayer));
}

#[test]
fn everything_in_front_of_opaque_is_peeled_and_nothing_behind_it() {
    let context = Context::headless().unwrap();
    for (opaque, layers) in [(LAST, 2), (500, 1), (0, 0)] {
        let stack = two_layers(Some(opaque));
        for compositing in BOTH {
            let frame = peel(
                &context,
                &stack.scene(),
                DepthPeelingOptions {
                    compositing,
                    ..Default::default()
                },
            );
            assert_eq!(frame.stats.layers, Some(layers), "opaque at {opaque}");
            assert_eq!(
                Comparison::new(&frame.image, &stack.expected(), F32)
                    .unwrap()
                    .over,
                0
            );
        }
    }
}

#[test]
fn a_fragment_on_the_opaque_surface_is_hidden_by_it() {
    let context = Context::headless().unwrap();
    let stack = two_layers(Some(600));
    let frame = peel(&context, &stack.scene(), DepthPeelingOptions::default());
    assert_eq!(
        (frame.stats.layers, frame.stats.fragments, frame.stats.lost),
        (Some(1), 6, Some(0))
    );
}

#[test]
fn a_fragment_of_alpha_0_is_a_layer_that_changes_nothing() {
    let context = Context::headless().unwrap();
    let piece = |level, a| Piece {
        level,
        color: [1.0, 0.0, 0.0, a],
    };
    let stack = Stack {
        width: 3,
        pixels: vec![vec![piece(10, 0.0), piece(20, 0.0)]; 6],
        opaque: None,
    };
    let frame = peel(&context, &stack.scene(), DepthPeelingOptions::default());
    assert_eq!((frame.stats.layers, frame.stats.lost), (Some(2), Some(0)));
    assert!(frame.image == stack.expected());
}

#[test]
fn a_pixel_that_is_finished_waits_for_the_others() {
    let context = Context::headless().unwrap();
    let piece = |level: u16| Piece {
        level,
        color: [f32::from(level) / 100.0, 0.5, 0.0, 0.5],
    };
    let pixels = (0..6).map(|n| (0..n * 4).map(piece).collect()).collect();
    let stack = Stack {
        width: 3,
        pixels,
        opaque: None,
    };
    let frame = peel(&context, &stack.scene(), DepthPeelingOptions::default());
    assert_eq!((frame.stats.layers, frame.stats.iterations), (Some(20), 21));
    assert_eq!(
        Comparison::new(&frame.image, &stack.expected(), F32)
            .unwrap()
            .over,
        0
    );
}

/// The deepest level.
const LAST: u16 = stack::LEVELS - 1;

/// Two layers at 300 and 600, the farther one submitted first.
fn two_layers(opaque: Option<u16>) -> Stack {
    let far = Piece {
        level: 600,
        color: [0.0, 0.5, 1.0, 0.25],
    };
    let near = Piece {
        level: 300,
        color: [1.0, 0.25, 0.0, 0.5],
    };
    Stack {
        width: 3,
        pixels: vec![vec![far, near]; 6],
        opaque,
    }
}

fn soup_scene(seed: u64) -> Scene {
    let mesh = soup(&Soup {
        triangle_size: [0.5, 1.5],
        seed,
        count: 300,
        ..Soup::default()
    })
    .unwrap();
    let mut scene = Scene::of("soup", vec![mesh]);
    scene.size = [160, 120];
    scene
}

/// Renders random stacks both ways and judges them. A failure prints the smallest stack as fragment lists.
fn check_stacks(
    strategy: impl proptest::strategy::Strategy<Value = Stack>,
    cases: u32,
    judge: impl Fn(&Stack, &Frame) -> Result<(), String>,
) {
    let context = Context::headless().unwrap();
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    let outcome = runner(cases).run(&strategy, |stack| {
        for compositing in BOTH {
            let method = Method::DepthPeeling(DepthPeelingOptions {
                compositing,
                ..Default::default()
            });
            let frame = renderer
                .borrow_mut()
                .render(&stack.scene(), &method)
                .unwrap();
            judge(&stack, &frame)
                .map_err(|why| TestCaseError::fail(format!("{compositing:?}: {why}")))?;
        }
        Ok(())
    });
    stack::expect_none(outcome);
}
