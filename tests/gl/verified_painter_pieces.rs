//! The verified painter's triangles in pieces, where they cross planes.

use glam::DVec3;
use onionskin::{Comparison, Context, Method, Renderer};

use crate::kit::bounds::F32;
use crate::kit::changed::{Change, with_change};
use crate::kit::render::example;
use crate::verified_painter::{METHOD, counts, error};

/// A cone through slices, seen from all sides: along the slices' normal, at an angle, in their planes, from between them, and
/// far from the origin. What is marked are single pixels, in which a fragment is rounded to the wrong side of a slice.
#[test]
fn triangles_that_cross_planes_are_drawn_in_pieces() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let mut scene = example("slices", [160, 120]);
    let triangles = scene.triangle_count() as u64;
    for eye in [
        [0.0, 0.0, 5.5],
        [3.0, 1.0, 4.0],
        [5.0, 0.0, 0.0],
        [-3.0, 2.0, -4.0],
        [0.1, 0.2, 0.3],
    ] {
        for away in [0.0, 3000.0] {
            let moved = DVec3::splat(away);
            let mut scene = scene.clone();
            for mesh in &mut scene.meshes {
                for vertex in &mut mesh.vertices {
                    vertex.position += moved;
                }
            }
            scene.camera.target = moved;
            scene.camera.eye = moved + DVec3::from(eye);
            scene.camera.near = 0.05;
            let frame = renderer.render(&scene, &METHOD).unwrap();
            let off = error(&context, &scene, &frame);
            println!("{eye:?} {away}: off by {off:.1e}, {:?}", counts(&frame));
            assert!(off <= F32, "{eye:?}, {away} away: {off}");
            assert!(counts(&frame).marked_pixels < 100, "{eye:?}, {away} away");
            assert!(frame.stats.triangles > triangles + 1000);
        }
    }
    // Without planes the cone's pixels are marked.
    scene.meshes[0].sorted = false;
    let frame = renderer.render(&scene, &METHOD).unwrap();
    assert!(counts(&frame).marked_pixels > 1000, "{:?}", counts(&frame));
}

/// By 1/w, and slices of a volume with a mesh through them: the oracle's image of the same slices.
#[test]
fn pieces_are_exact_among_other_depths_and_other_slices() {
    let context = Context::headless().unwrap();
    let scene = example("slices", [120, 90]);
    let mut renderer = Renderer::new(&context, 120, 90).unwrap().with_inverse_w();
    let frame = renderer.render(&scene, &METHOD).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap();
    let hanging = exact.hanging.unwrap().drawn;
    let compared = Comparison::among(&frame.image, &exact.image, F32, |p| !hanging[p]).unwrap();
    assert!(compared.max <= F32, "{}", compared.max);
    assert!(counts(&frame).marked_pixels < 100);

    let scene = example("fog", [120, 90]);
    let mut renderer = Renderer::new(&context, 120, 90)
        .unwrap()
        .with_slices(32)
        .unwrap();
    let frame = renderer.render(&scene, &METHOD).unwrap();
    let peeled = renderer
        .render(&scene, &Method::LayerPeeling(Default::default()))
        .unwrap();
    let off = Comparison::new(&frame.image, &peeled.image, F32)
        .unwrap()
        .max;
    println!("fog: off by {off:.1e}, {:?}", counts(&frame));
    assert!(off <= F32, "{off}");
}

const CHANGES_OF_PIECES: [Change; 3] = [
    [
        "verified/pieces.glsl",
        "along < bounds.y",
        "along < bounds.x",
    ],
    ["verified/pieces.glsl", "int(number) + 1", "int(number)"],
    [
        "verified/pieces.vert",
        "along_normal(position)",
        "-along_normal(position)",
    ],
];

#[test]
fn a_changed_word_about_pieces_is_noticed() {
    let context = Context::headless().unwrap();
    let scene = example("slices", [80, 60]);
    for change in CHANGES_OF_PIECES {
        let mut renderer = with_change(Renderer::new(&context, 80, 60).unwrap(), change);
        let frame = renderer.render(&scene, &METHOD).unwrap();
        let off = error(&context, &scene, &frame);
        let marked = counts(&frame).marked_pixels;
        println!("{change:?}: {off}, {marked} marked");
        assert!(
            off > 1e-3 || marked > 20,
            "{change:?}: {off}, {marked} marked"
        );
    }
}
