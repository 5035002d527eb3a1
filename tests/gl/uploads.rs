//! How often scenes are uploaded: once, wherever only the camera moves, and never while a frame is drawn.

use glam::DVec3;
use onionskin::low_level::methods::{CoherentOptions, CountBy, Variant, registry};
use onionskin::low_level::scene::Camera;
use onionskin::low_level::scene::generate::{Soup, soup};
use onionskin::{Context, Method, Renderer, Scene};

use crate::kit::fog_scenes::random_scene;

const SIZE: [u32; 2] = [24, 18];
const MESHES: u64 = 2;

fn scene() -> Scene {
    let triangles = |seed| {
        soup(&Soup {
            count: 40,
            seed,
            ..Soup::default()
        })
    };
    let meshes = (0..MESHES).map(|seed| triangles(seed).unwrap());
    let mut scene = Scene::of("two soups", meshes.collect());
    scene.size = SIZE;
    scene
}

/// Around the scene, so that every view has another order.
fn cameras(scene: &Scene) -> Vec<Camera> {
    let from = |number: i32| {
        let angle = f64::from(number) * 1.3;
        let distance = scene.camera.eye.distance(scene.camera.target);
        let away = DVec3::new(angle.sin(), 0.2, angle.cos()).normalize() * distance;
        Camera {
            eye: scene.camera.target + away,
            ..scene.camera
        }
    };
    (0..4).map(from).collect()
}

/// The buffers and textures that some work fills.
fn uploads<T>(context: &Context, work: impl FnOnce() -> T) -> (T, u64) {
    let before = context.uploads();
    let done = work();
    (done, context.uploads() - before)
}

#[test]
fn a_film_has_the_frames_that_are_rendered_one_by_one_and_uploads_vertices_once() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let cameras = cameras(&scene);
    let mut sorted = Vec::new();
    for row in registry() {
        if !row.runs_on(context.driver()) {
            continue;
        }
        let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
        let (frames, uploads) = uploads(&context, || {
            let mut film = renderer.film(scene.clone(), &row.method);
            let frame = |camera: &Camera| film.frame_and_count(*camera, CountBy::default());
            cameras.iter().map(frame).collect::<Vec<_>>()
        });
        for (frame, &camera) in frames.into_iter().zip(&cameras) {
            let (mut frame, complexity) = frame.unwrap();
            let seen = Scene {
                camera,
                ..scene.clone()
            };
            let mut alone = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
            let expected = alone.render_and_count(&seen, &row.method, CountBy::default());
            let (expected, counted) = expected.unwrap();
            frame.stats.ms = expected.stats.ms;
            assert_eq!(frame.image, expected.image, "{}", row.name);
            assert_eq!(frame.stats, expected.stats, "{}", row.name);
            assert_eq!(complexity, counted, "{}", row.name);
        }
        if sorts_every_frame(row.method) {
            // The vertices of all meshes once. Its sort is part of every frame: sorted triangles, those for lists, and all
            // of them to be counted.
            let frames = cameras.len() as u64;
            let expected = 1 + 2 * frames..=1 + 3 * frames;
            assert!(expected.contains(&uploads), "{uploads}");
            continue;
        }
        // Vertices, and the triangles in each order that there was.
        let orders = uploads / MESHES - 1;
        assert_eq!(uploads, MESHES * (1 + orders), "{}", row.name);
        assert!((1..=4).contains(&orders), "{}: {uploads}", row.name);
        if orders > 1 {
            sorted.push(row.name);
        }
    }
    println!("in other orders: {sorted:?}");
    // What sorts triangles by the view is known, and nothing else uploads twice.
    let sorts = |name: &&str| *name == "painter" || name.contains("coherent");
    assert!(
        sorted.iter().all(sorts) && sorted.contains(&"painter"),
        "{sorted:?}"
    );
}

/// On a scene of surfaces, the automatic method is the verified painter.
fn sorts_every_frame(method: Method) -> bool {
    matches!(method, Method::VerifiedPainter | Method::Automatic)
}

#[test]
fn no_frame_uploads_while_it_is_drawn_but_the_verified_painter_s_that_sorts() {
    let context = Context::headless().unwrap();
    let scene = scene();
    let batches = |variant| {
        Method::CoherentLayerPeeling(CoherentOptions {
            variant,
            batches: 3,
            ..CoherentOptions::default()
        })
    };
    let all = registry()
        .iter()
        .filter(|row| row.runs_on(context.driver()) && !sorts_every_frame(row.method));
    let all = all.map(|row| row.method);
    for method in all.chain([Variant::A, Variant::B].map(batches)) {
        let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1]).unwrap();
        // Two frames at the least.
        let (_, uploads) = uploads(&context, || {
            renderer.measure(&scene, &method, 3).unwrap();
        });
        assert_eq!(uploads, 2 * MESHES, "{method:?}");
    }
}

#[test]
fn a_film_of_volumes_uploads_their_samples_once_and_slices_for_every_frame() {
    let context = Context::headless().unwrap();
    let scene = random_scene(5);
    let (meshes, volumes) = (scene.meshes.len() as u64, scene.volumes.len() as u64);
    assert!(meshes == 2 && volumes == 2);
    let cameras = cameras(&scene);
    let [width, height] = scene.size;
    for (name, expected) in [
        // A box for each volume, and its samples.
        ("ppll+ppdp", 2 * (meshes + volumes) + volumes),
        // All slices are one mesh.
        ("hybrid-layer-peeling", 4 * (2 * (meshes + 1) + volumes)),
    ] {
        let method: Method = name.parse().unwrap();
        let mut renderer = Renderer::new(&context, width, height).unwrap();
        let (frames, uploads) = uploads(&context, || {
            let mut film = renderer.film(scene.clone(), &method);
            let frames = cameras.iter().map(|&camera| film.frame(camera).unwrap());
            frames.collect::<Vec<_>>()
        });
        assert_eq!(uploads, expected, "{name}");
        for (frame, &camera) in frames.iter().zip(&cameras) {
            let seen = Scene {
                camera,
                ..scene.clone()
            };
            let mut alone = Renderer::new(&context, width, height).unwrap();
            assert_eq!(frame.image, alone.render(&seen, &method).unwrap().image);
        }
    }
}
