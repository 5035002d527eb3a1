//! The method that chooses for the scene: its choice, which it says, and its image, which is exact.

use onionskin::generate::{Quads, Soup, quads, soup};
use onionskin::{Comparison, Context, Frame, Method, Scene};

use crate::fused::BOUND;
use crate::kit::bounds::F32;
use crate::kit::chance::Chance;
use crate::kit::fog_scenes::random_scene;
use crate::kit::render::{example, render};
use crate::kit::slack;
use crate::kit::stack::{expect_none, runner, stacks};

fn chosen(frame: &Frame) -> &'static str {
    frame.stats.chosen.expect("a choice").method
}

/// The largest difference from the oracle's image. Of surfaces, pixels are left out that hang on a difference of depth that
/// the depth buffer cannot hold. Of volumes, so much is allowed as comes of where the rasteriser has their faces.
fn off(context: &Context, scene: &Scene, frame: &Frame) -> f64 {
    let exact = render(context, scene, &Method::Exact);
    if !scene.volumes.is_empty() {
        return slack::compare(frame, &exact, scene).1;
    }
    let hanging = &exact.hanging.as_ref().expect("the oracle says which").drawn;
    let among = |pixel: usize| !hanging[pixel];
    let compared = Comparison::among(&frame.image, &exact.image, F32, among);
    compared.expect("two images of one size").max
}

#[test]
fn it_is_the_default() {
    assert_eq!(Method::default(), Method::Automatic);
}

/// Large triangles through one another, none of which has a place in the order of the others.
fn crossing(size: [u32; 2]) -> Scene {
    let triangles = soup(&Soup {
        count: 200,
        triangle_size: [2.0, 3.0],
        alpha: [0.1, 0.9],
        ..Soup::default()
    });
    let mut scene = Scene::of("crossing", vec![triangles.unwrap()]);
    scene.size = size;
    scene
}

/// Scenes that are made to prefer each of the methods, with what the frame says.
#[test]
fn each_method_is_chosen_where_it_is_quick_and_said() {
    let context = Context::headless().unwrap();
    for (name, expected) in [
        ("knots", "verified-painter"),
        ("sheets64", "verified-painter"),
        ("slices", "verified-painter"),
        ("crossing", "dfb+ppao+ppdp"),
        ("fog", "dfb+ppdp"),
    ] {
        let scene = match name {
            "crossing" => crossing([80, 60]),
            _ => example(name, [80, 60]),
        };
        let frame = render(&context, &scene, &Method::Automatic);
        assert_eq!(chosen(&frame), expected, "{name}");
        let said = frame.stats.to_string();
        let why = frame.stats.chosen.expect("a choice").why;
        assert!(
            said.contains(&format!("{expected}: {why}\n")),
            "{name}: {said}"
        );
        let off = off(&context, &scene, &frame);
        assert!(off <= F32, "{name}: {off}");
        assert_eq!(frame.stats.lost, Some(0), "{name}");
    }
}

/// It is the method that it chose, to the bit, and counts the same.
#[test]
fn its_image_is_the_chosen_method_s() {
    let context = Context::headless().unwrap();
    let scenes = [
        (example("knots", [80, 60]), None),
        (example("molecule_fused", [80, 60]), Some("float")),
        (crossing([80, 60]), Some("fixed")),
    ];
    for (scene, color) in scenes {
        let name = &scene.name;
        let frame = render(&context, &scene, &Method::Automatic);
        let mut method: Method = chosen(&frame).parse().unwrap();
        assert_eq!(method.has("record-color"), color.is_some(), "{name}");
        if let Some(color) = color {
            let is_in_order = context.driver().has("GL_EXT_shader_framebuffer_fetch");
            let color = if is_in_order { color } else { "float" };
            method.choose("record-color", color).unwrap();
        }
        let alone = render(&context, &scene, &method);
        assert!(frame.image == alone.image, "{name}");
        assert_eq!(frame.stats.geometry_passes, alone.stats.geometry_passes);
        assert_eq!(frame.stats.triangles, alone.stats.triangles);
        assert_eq!(frame.stats.bytes, alone.stats.bytes);
        assert_eq!(alone.stats.chosen, None);
    }
}

#[test]
fn random_stacks_are_exact() {
    let context = Context::headless().unwrap();
    let outcome = runner(40).run(&stacks(500, false), |stack| {
        let frame = render(&context, &stack.scene(), &Method::Automatic);
        let compared = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
        proptest::prop_assert!(compared.max <= F32, "off by {}", compared.max);
        Ok(())
    });
    expect_none(outcome);
}

/// Random triangles, alone, in front of opaque ones, and among quads that are sorted.
#[test]
fn random_triangles_are_exact() {
    let context = Context::headless().unwrap();
    let mut chance = Chance::new(16);
    let mut choices = Vec::new();
    for number in 0..40 {
        let (most, triangle_size) = [(60, [0.2, 0.8]), (200, [2.0, 3.0])][number / 4 % 2];
        let triangles = |count, alpha, seed| {
            let parameters = Soup {
                count,
                alpha,
                seed,
                triangle_size,
                ..Soup::default()
            };
            soup(&parameters).unwrap()
        };
        let seed = chance.below(1 << 30) as u64;
        let mut meshes = vec![triangles(most, [0.0, 1.0], seed)];
        if number % 2 == 1 {
            meshes.push(triangles(6, [1.0, 1.0], seed + 1));
        }
        if number % 4 > 1 {
            let mut stack = quads(&Quads::default()).unwrap();
            stack.sorted = true;
            meshes.push(stack);
        }
        let mut scene = Scene::of("random", meshes);
        scene.size = [64, 48];
        let frame = render(&context, &scene, &Method::Automatic);
        let off = off(&context, &scene, &frame);
        assert!(off <= F32, "scene {number}, seed {seed}: {off}");
        choices.push(chosen(&frame));
    }
    for method in ["verified-painter", "dfb+ppao+ppdp"] {
        let count = choices.iter().filter(|&&chosen| chosen == method).count();
        assert!(count >= 5, "{method}: {count}");
    }
}

/// The eye among triangles of all sizes, which the near plane cuts and some of which lie far outside of the image; with
/// scenes at the origin and far from it.
#[test]
fn random_triangles_around_the_eye_are_exact() {
    let context = Context::headless().unwrap();
    let mut chance = Chance::new(21);
    let mut in_lists = 0;
    for number in 0..60 {
        let seed = chance.below(1 << 30) as u64;
        let parameters = Soup {
            count: 80,
            alpha: [0.1, 0.9],
            triangle_size: [0.01, 4.0],
            seed,
            ..Soup::default()
        };
        let mut mesh = soup(&parameters).unwrap();
        let away = chance.vector([0.0, 1e3][number % 2]);
        for vertex in &mut mesh.vertices {
            vertex.position += away;
        }
        let mut scene = Scene::of("around the eye", vec![mesh]);
        scene.size = [[64, 48], [17, 90], [1, 1]][number % 3];
        scene.camera.eye = away + chance.vector(0.5);
        scene.camera.target = scene.camera.eye + chance.vector(1.0);
        (scene.camera.near, scene.camera.far) = (10_f64.powf(chance.between(-4.0, -0.5)), 10.0);
        let frame = render(&context, &scene, &Method::Automatic);
        let off = off(&context, &scene, &frame);
        assert!(off <= F32, "scene {number}, seed {seed}: {off}");
        in_lists += frame
            .stats
            .verified
            .map_or(0, |counts| counts.list_fragments);
    }
    assert!(in_lists > 10_000, "{in_lists}");
}

#[test]
fn random_volumes_are_exact() {
    let context = Context::headless().unwrap();
    for seed in 0..20 {
        let scene = random_scene(seed);
        let frame = render(&context, &scene, &Method::Automatic);
        let off = off(&context, &scene, &frame);
        assert!(off <= BOUND, "scene {seed}: {off}");
        assert_eq!(chosen(&frame), "dfb+ppdp");
    }
}

/// Four images of 16 bytes a pixel, and 1.3 times the records of what is in lists, are enough for every choice, with opaque
/// surfaces and without.
#[test]
fn its_memory_is_bounded_by_what_is_out_of_order() {
    let context = Context::headless().unwrap();
    let size = [320, 240];
    let mut scenes: Vec<Scene> = ["knots", "molecule", "quads", "slices", "soup", "teapot"]
        .map(|name| example(name, size))
        .into();
    scenes.push(crossing(size));
    let mut half = crossing(size);
    half.meshes[0] = soup(&Soup::default()).unwrap();
    let floor = quads(&Quads {
        count: 1,
        alpha: 1.0,
        ..Quads::default()
    });
    half.meshes.push(floor.unwrap());
    scenes.push(half);
    let mut largest: f64 = 0.0;
    for scene in &scenes {
        let frame = render(&context, scene, &Method::Automatic);
        let stats = &frame.stats;
        let records = match (stats.verified, stats.a_buffer) {
            // The lists have room for somewhat more, and that is not what must be there.
            (Some(counts), _) => 16 * counts.list_fragments,
            (None, Some(counts)) => counts.list_bytes,
            (None, None) => panic!("{}: no counts", scene.name),
        };
        let image = f64::from(size[0] * size[1] * 16);
        let images = (stats.bytes as f64 - 1.3 * records as f64) / image;
        let name = &scene.name;
        println!(
            "{name}: {images:.2} images, {records} bytes of records, {}",
            chosen(&frame)
        );
        assert!(images <= 4.0, "{name}: {images}");
        largest = largest.max(images);
    }
    // It is not less by so much that a copy more would go unnoticed.
    assert!(largest > 3.0, "{largest}");
}

/// The comparisons above notice a scene without its last mesh.
#[test]
fn a_mesh_that_is_missing_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_scene(1);
    let mut without = scene.clone();
    without.meshes.pop();
    let frame = render(&context, &without, &Method::Automatic);
    assert!(off(&context, &scene, &frame) > BOUND);
}
