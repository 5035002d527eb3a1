//! What the history of a pixel tells: layers without end, what is lost and why, distances, and what could not be compared.

use onionskin::inspect::{self, Loss, Where};
use onionskin::low_level::edition::history_json;
use onionskin::low_level::steps::Reason;
use onionskin::{Context, Method, Renderer};

use crate::inspect::figure_2;
use crate::kit::render::example;
use crate::kit::stack::{LEVELS, Piece, Stack};

/// Layers enough that what a method adds up in 32 bits would drown a sixteenth of what is left.
#[test]
fn a_pixel_of_two_hundred_layers_is_told_to_the_last() {
    const LAYERS: u16 = 200;
    let pieces = (0..LAYERS).map(|number| Piece {
        // In no order, and none twice: 7 and 200 have no factor in common.
        level: number * 7 % LAYERS * (LEVELS / LAYERS),
        color: [0.5, 0.25, 0.75, 0.01],
    });
    let stack = Stack {
        width: 1,
        pixels: vec![pieces.collect()],
        opaque: None,
    };
    let scene = stack.scene();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for name in [
        "depth-peeling",
        "dual-depth-peeling",
        "coherent-layer-peeling-b",
        "dfb+ppao+ppdp",
    ] {
        let method: Method = name.parse().unwrap();
        let history = inspect::history(&mut renderer, &scene, &method, [0, 0]).unwrap();
        let composited = history.composited.as_ref().expect(name);
        assert_eq!(composited.layers.len(), usize::from(LAYERS), "{name}");
        assert_eq!(history.parts_at, None, "{name}");
    }
}

/// All pixels are off by what 16-bit colours leave out. One has lost a fragment, too, of which hardly anything is to be seen.
#[test]
fn a_pixel_that_has_lost_something_is_found_among_many_that_are_only_rounded() {
    let piece = |level| Piece {
        level,
        color: [0.3, 0.6, 0.1, 0.7],
    };
    let layers = |count: u16| {
        (0..count)
            .map(|number| piece(number * 20))
            .collect::<Vec<_>>()
    };
    let mut pixels = vec![layers(8); 200];
    pixels[77] = layers(9);
    let stack = Stack {
        width: 20,
        pixels,
        opaque: None,
    };
    let scene = stack.scene();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 20, 10).unwrap();
    let mut method: Method = "ffb".parse().unwrap();
    method.choose("array", "8").unwrap();
    let found = inspect::find(&mut renderer, &scene, &method, Where::Lost).unwrap();
    let pixel = found.expect("one has lost its ninth fragment");
    assert_eq!(pixel, [77 % 20, 77 / 20]);
    let history = inspect::history(&mut renderer, &scene, &method, pixel).unwrap();
    let losses: Vec<_> = history.fragments.iter().filter_map(|it| it.loss).collect();
    assert_eq!(losses, [Loss::Dropped]);
    method.choose("array", "16").unwrap();
    let found = inspect::find(&mut renderer, &scene, &method, Where::Lost).unwrap();
    assert_eq!(found, None);
}

#[test]
fn what_is_lost_says_why() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let losses = |method: &Method, renderer: &mut Renderer<'_>| -> Vec<Loss> {
        let history = inspect::history(renderer, &figure_2(), method, [0, 0]).unwrap();
        history.fragments.iter().filter_map(|it| it.loss).collect()
    };
    for (name, option, value, count, loss) in [
        (
            "depth-peeling",
            "peels",
            "3",
            8,
            Loss::Ended(Reason::PeelLimit),
        ),
        ("ffb", "array", "8", 3, Loss::Dropped),
        ("ffb", "fixed-layers", "4", 7, Loss::NoRoom),
    ] {
        let mut method: Method = name.parse().unwrap();
        method.choose(option, value).unwrap();
        assert_eq!(
            losses(&method, &mut renderer),
            vec![loss; count],
            "{name} {option}"
        );
    }
    let exact: Method = "dfb+ppdp".parse().unwrap();
    assert!(losses(&exact, &mut renderer).is_empty());
}

/// Stored as 1/w, a depth is told as the distance from the eye.
#[test]
fn depths_by_1_over_w_are_told_as_distances() {
    let context = Context::headless().unwrap();
    let scene = example("teapot", [64, 48]);
    let renderer = Renderer::new(&context, 64, 48).unwrap();
    let mut renderer = renderer.with_inverse_w();
    let method: Method = "depth-peeling".parse().unwrap();
    let history = inspect::history(&mut renderer, &scene, &method, [32, 24]).unwrap();
    assert!(history.by_distance && history.fragments.len() > 2);
    let camera = &scene.camera;
    let forward = (camera.target - camera.eye).normalize();
    for fragment in &history.fragments {
        let mesh = scene
            .meshes
            .iter()
            .find(|it| it.name == fragment.mesh)
            .unwrap();
        let corners = mesh.corners(fragment.triangle as usize);
        let distances = corners.map(|it| (it.position - camera.eye).dot(forward));
        let [low, high] = [f64::min, f64::max].map(|of| distances.into_iter().reduce(of).unwrap());
        assert!(
            (low..=high).contains(&fragment.depth),
            "{} of {low} to {high}",
            fragment.depth
        );
        // Some roundings of 2^-24.
        let off = f64::from(fragment.stored_depth) / fragment.depth - 1.0;
        assert!(off.abs() < 1e-6, "{off}");
    }
    let peels = history.passes.iter().flat_map(|pass| &pass.events);
    let stored = peels.filter(|event| event.depth[0] != event.depth[1]);
    for event in stored {
        let [before, after] = event.depth;
        assert_eq!(
            after,
            history.fragments[event.fragment as usize].stored_depth
        );
        assert!(after < before);
    }
    // The first peel begins with depths infinitely far away.
    assert_eq!(history.passes[0].held.depth, Some(f32::INFINITY));
}

#[test]
fn what_cannot_be_followed_is_not_said_to_agree() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let followed: Method = "depth-peeling".parse().unwrap();
    let mut not_followed = followed;
    not_followed.choose("depth-unit-0", "classic").unwrap();
    for (method, agree) in [
        (followed, serde_json::json!(true)),
        (not_followed, serde_json::json!(null)),
    ] {
        let history = inspect::history(&mut renderer, &figure_2(), &method, [0, 0]).unwrap();
        assert_eq!(history_json::object(&history)["agree"], agree);
    }
}
