//! What lies in front in the exact image: decided by geometry, not by what a depth buffer holds.

use std::cell::RefCell;

use crate::kit::bounds::F32;
use crate::kit::cast::{Hit, cast};
use crate::kit::driver::interpolates_true_corners;
use crate::kit::render::example;
use glam::{DMat3, DQuat, DVec3, Vec3};
use onionskin::{
    Camera, Comparison, Context, Frame, Mesh, Method, Renderer, Rgba, Scene, Vertex, registry,
};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// A colour that f32 interpolates and f64 composites: a few roundings of 2^-24 each.
const BOUND: f64 = 1e-6;

/// An engine's usual planes, and a view from the origin.
fn camera() -> Camera {
    Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov: 40.0,
        near: 0.1,
        far: 1000.0,
    }
}

/// A quad around `middle`, spanned by two half edges.
fn pane(middle: DVec3, [right, up]: [DVec3; 2], color: [f32; 4]) -> Mesh {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let corner = |(x, y): (f64, f64)| Vertex {
        position: middle + right * x + up * y,
        normal: Vec3::Z,
        color: Rgba::from(color),
    };
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    Mesh::new("pane", corners.map(corner).to_vec(), triangles)
}

fn scene(meshes: Vec<Mesh>) -> Scene {
    let mut scene = Scene::of("panes", meshes);
    (scene.size, scene.camera) = ([48, 36], camera());
    scene
}

fn exact(context: &Context, scene: &Scene) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &Method::Exact).unwrap()
}

/// Over black: sorted by distance, opaque surfaces hide what is behind and on them.
fn composited(mut hits: Vec<Hit>) -> [f64; 3] {
    hits.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
    let wall = hits.iter().find(|hit| hit.color[3] == 1.0).copied();
    let limit = wall.map_or(f64::INFINITY, |wall| wall.depth);
    let (mut image, mut visible) = ([0.0; 3], 1.0);
    let seen = hits.into_iter().filter(|hit| hit.depth < limit);
    for Hit { color, .. } in seen.chain(wall) {
        for (channel, value) in image.iter_mut().zip(color) {
            *channel += visible * color[3] * value;
        }
        visible *= 1.0 - color[3];
    }
    image
}

/// Pixels whose colour is not the rays', of those that no edge passes near to; and how many those are.
fn wrong(frame: &Frame, scene: &Scene) -> (usize, usize) {
    wrong_by(frame, scene, BOUND)
}

fn wrong_by(frame: &Frame, scene: &Scene, bound: f64) -> (usize, usize) {
    let rays = cast(scene);
    let pixels = frame.image.pixels.iter().zip(rays.pixels);
    let certain = pixels.zip(rays.doubtful).filter(|(_, doubtful)| !doubtful);
    let mut counts = (0, 0);
    for ((pixel, hits), _) in certain {
        let expected = composited(hits);
        let mut channels = pixel.to_array().into_iter().zip(expected);
        let right = channels.all(|(a, b)| (f64::from(a) - b).abs() <= bound);
        counts.0 += usize::from(!right);
        counts.1 += 1;
    }
    counts
}

#[track_caller]
fn assert_right(frame: &Frame, scene: &Scene) {
    let (wrong, certain) = wrong(frame, scene);
    assert_eq!(wrong, 0, "of {certain} pixels");
}

const GREEN: [f32; 4] = [0.0, 1.0, 0.0, 0.5];
const RED: [f32; 4] = [1.0, 0.0, 0.0, 0.5];

/// Two panes 1 cm apart, 100 away, tilted a little and with corners of their own, so that a rasteriser's depths have more
/// than one value and are rounded in more than one way.
fn one_centimetre_apart() -> Scene {
    let far = tilted(100.01, 100.0, 0.0, GREEN);
    let near = tilted(100.0, 93.0, 0.4, RED);
    scene(vec![far, near])
}

/// A pane whose edges are turned in its plane.
fn tilted(distance: f64, half: f64, turned: f64, color: [f32; 4]) -> Mesh {
    let turn = DQuat::from_rotation_y(0.02) * DQuat::from_rotation_z(turned);
    let edges = [turn * DVec3::X * half, turn * DVec3::Y * half];
    pane(DVec3::NEG_Z * distance, edges, color)
}

#[test]
fn two_panes_1_cm_apart_100_away_are_in_their_order() {
    let context = Context::headless().unwrap();
    let scene = one_centimetre_apart();
    let frame = exact(&context, &scene);
    assert_right(&frame, &scene);
    // All that both cover hang on it with the planes as given, and none with those that the scene needs.
    let hanging = frame.hanging.unwrap();
    let both = scene.size[0] * scene.size[1];
    let count = |mask: &[bool]| mask.iter().filter(|&&hangs| hangs).count() as u32;
    assert_eq!(count(&hanging.given), both);
    assert_eq!(count(&hanging.drawn), 0);
}

/// Two steep panes, 0.0001 apart along the view direction. At a distance z of 2.7 to 6 their depths differ by
/// 10/9 x 0.0001 / 4z, which is 4.6e-6 to 1.0e-5. Roundings are good for 4e-6 (2 x 1.2e-6, and 2 x 0.8e-6 for the shape of the
/// triangles) and corners that are snapped for 3.1e-5, because the depth changes by 0.0056 from pixel to pixel. Snapping
/// decides on every driver where the centre of a pixel lies beside the triangle, at a few pixels of the outline.
#[test]
fn another_renderer_may_snap_corners_whatever_this_driver_does() {
    let context = Context::headless().unwrap();
    let edges = [DVec3::new(2.0, 0.0, -2.0), DVec3::Y * 10.0];
    let steep = |z: f64, color| pane(DVec3::NEG_Z * z, edges, color);
    let mut scene = scene(vec![steep(4.0, RED), steep(4.0001, GREEN)]);
    (scene.camera.near, scene.camera.far) = (1.0, 10.0);
    let [width, height] = scene.size;
    let renderer = Renderer::new(&context, width, height).unwrap();
    let frame = renderer
        .with_given_planes()
        .render(&scene, &Method::Exact)
        .unwrap();
    let hanging = frame.hanging.unwrap();
    let count = |mask: &[bool]| mask.iter().filter(|&&hangs| hangs).count();
    assert!(count(&hanging.given) > 1000, "{}", count(&hanging.given));
    match context.driver().quirks().interpolates_true_corners {
        true => assert!(count(&hanging.drawn) < 10, "{}", count(&hanging.drawn)),
        false => assert_eq!(hanging.drawn, hanging.given),
    }
}

#[test]
fn a_depth_buffer_between_the_given_planes_reverses_them_and_fitted_planes_do_not() {
    let context = Context::headless().unwrap();
    if !interpolates_true_corners(&context) {
        return;
    }
    // Straight, as in many an engine's bug report, and seen from a little aside.
    let edges = [DVec3::X * 20.0, DVec3::Y * 20.0];
    let far = pane(DVec3::NEG_Z * 0.01, edges, GREEN);
    let mut scene = scene(vec![far, pane(DVec3::ZERO, edges, RED)]);
    scene.camera.eye = DVec3::new(3.0, 2.0, 100.0);
    scene.camera.target = DVec3::ZERO;
    let [width, height] = scene.size;
    let method = Method::DepthPeeling(Default::default());
    let fitted = Renderer::new(&context, width, height).unwrap();
    let given = Renderer::new(&context, width, height)
        .unwrap()
        .with_given_planes();
    let [fitted, given] = [fitted, given].map(|mut r| r.render(&scene, &method).unwrap());
    assert_right(&fitted, &scene);
    let (wrong, _) = wrong(&given, &scene);
    assert!(
        wrong > 10,
        "{wrong}: the scene asks for more than the buffer holds"
    );
    let lost = given.stats.lost.unwrap();
    assert!(
        wrong as u64 > lost,
        "{wrong}, of which only {lost} are counted as ties"
    );
}

#[test]
fn an_opaque_pane_2_mm_before_a_transparent_one_hides_it() {
    let context = Context::headless().unwrap();
    let glass = tilted(80.002, 80.0, 0.4, RED);
    let wall = tilted(80.0, 90.0, 0.0, [0.25, 0.5, 0.75, 1.0]);
    let scene = scene(vec![glass, wall]);
    let frame = exact(&context, &scene);
    assert_right(&frame, &scene);
    let red = |pixel: &&Rgba| pixel.r > 0.25 + BOUND as f32;
    assert_eq!(frame.image.pixels.iter().filter(red).count(), 0);
}

/// A wall turned to any side, and a decal in its plane whose corners are its own, in decimal numbers.
fn wall_and_decal(turn: DQuat, alpha: f32) -> Vec<Mesh> {
    let place = |x: f64, y: f64| DVec3::new(x, y, 0.1 * x - 0.3 * y);
    let quad = |corners: [(f64, f64); 4], [r, g, b]: [f32; 3], alpha: f32| {
        let corner = |(x, y): (f64, f64)| Vertex {
            position: turn * place(x, y) + DVec3::NEG_Z * 60.0,
            normal: Vec3::Z,
            color: Rgba::new(r, g, b, alpha),
        };
        let corners = corners.map(corner).to_vec();
        Mesh::new("in the plane", corners, vec![[0, 1, 2], [0, 2, 3]])
    };
    let wall = [(-31.0, -29.0), (33.0, -27.0), (30.0, 32.0), (-30.0, 28.0)];
    let decal = [(-7.3, -5.1), (6.7, -4.9), (8.1, 7.7), (-6.1, 5.3)];
    vec![
        quad(wall, [1.0, 0.0, 0.0], alpha),
        quad(decal, [0.0, 0.0, 1.0], 0.5),
    ]
}

#[test]
fn a_decal_in_the_plane_of_its_wall_lies_behind_it_everywhere_if_it_was_submitted_later() {
    let context = Context::headless().unwrap();
    for (x, y) in [(0.0, 0.0), (0.3, 0.4), (-0.7, 0.2), (0.1, -0.9)] {
        let turn = DQuat::from_rotation_x(x) * DQuat::from_rotation_y(y);
        // Red first, then half of blue; the other way round; and a wall that hides what lies on it.
        let glass = wall_and_decal(turn, 0.5);
        let mut reversed = glass.clone();
        reversed.reverse();
        let cases = [
            (glass, [0.5, 0.0, 0.25]),
            (reversed, [0.25, 0.0, 0.5]),
            (wall_and_decal(turn, 1.0), [1.0, 0.0, 0.0]),
        ];
        for (meshes, [r, g, b]) in cases {
            let scene = scene(meshes);
            let image = exact(&context, &scene).image;
            let rays = cast(&scene);
            let covered = rays.pixels.iter().zip(&rays.doubtful);
            let decal = covered.map(|(hits, doubtful)| hits.len() == 2 && !doubtful);
            let pixels = image.pixels.iter().zip(decal);
            let pixels: Vec<_> = pixels.filter(|(_, decal)| *decal).map(|(p, _)| p).collect();
            assert!(pixels.len() > 50, "{}", pixels.len());
            let right = |pixel: &&Rgba| {
                let off = [pixel.r - r, pixel.g - g, pixel.b - b];
                off.iter().all(|off| f64::from(off.abs()) <= BOUND)
            };
            let wrong = pixels.iter().filter(|pixel| !right(pixel)).count();
            assert_eq!(wrong, 0, "of {}, turned by {x} {y}", pixels.len());
        }
    }
}

#[test]
fn a_decal_a_micrometre_before_its_wall_is_before_it() {
    let context = Context::headless().unwrap();
    let mut meshes = wall_and_decal(DQuat::from_rotation_y(0.3), 0.5);
    for vertex in &mut meshes[1].vertices {
        vertex.position.z += 1e-6;
    }
    let scene = scene(meshes);
    assert_right(&exact(&context, &scene), &scene);
}

/// A pane of a random scene: how far away, which way turned, its colour, and whether it is opaque.
type Pane = (f64, [f64; 3], [f32; 3], f32);

fn random_panes() -> impl Strategy<Value = Vec<Pane>> {
    let gap = prop_oneof![1e-5..1e-3, 1e-3..1e-1, 0.1..10.0];
    let alpha = prop_oneof![4 => 0.1_f32..0.9, 1 => Just(1.0_f32)];
    let turn = [-0.3..0.3, -0.3..0.3, -3.0..3.0];
    let color = [0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0];
    let rest = proptest::collection::vec((gap, color, alpha), 1..7);
    // One way of turning for all, so that they cross nowhere but follow each other as closely as the gaps say.
    (5.0..500.0, turn, rest).prop_map(|(first, turn, rest)| {
        let mut distance = first;
        rest.into_iter()
            .map(|(gap, color, alpha)| {
                distance += gap;
                (distance, turn, color, alpha)
            })
            .collect()
    })
}

fn scene_of(panes: &[Pane], shuffle: usize) -> Scene {
    let mut meshes: Vec<Mesh> = panes
        .iter()
        .map(|&(distance, [x, y, z], [r, g, b], alpha)| {
            let turn =
                DQuat::from_rotation_z(z) * DQuat::from_rotation_y(y) * DQuat::from_rotation_x(x);
            let axes = DMat3::from_quat(turn);
            let edges = [axes.x_axis * distance, axes.y_axis * distance];
            pane(DVec3::NEG_Z * distance, edges, [r, g, b, alpha])
        })
        .collect();
    let count = meshes.len();
    meshes.rotate_left(shuffle % count);
    let mut scene = scene(meshes);
    scene.size = [16, 12];
    scene
}

#[test]
fn random_panes_at_random_distances_are_in_the_order_of_the_rays() {
    let context = Context::headless().unwrap();
    let seed = [7; 32];
    println!("seed {seed:?}");
    let config = Config {
        cases: 200,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(config, rng);
    let renderer = RefCell::new(Renderer::new(&context, 16, 12).unwrap());
    let result = runner.run(&(random_panes(), 0..6_usize), |(panes, shuffle)| {
        let scene = scene_of(&panes, shuffle);
        let frame = renderer.borrow_mut().render(&scene, &Method::Exact);
        let frame = frame.unwrap();
        let (wrong, certain) = wrong(&frame, &scene);
        prop_assert_eq!(wrong, 0, "of {} pixels", certain);
        Ok(())
    });
    result.unwrap_or_else(|failure| panic!("{failure}"));
}

/// A floor at the eye's feet, which keeps the near plane near, and panes a ten thousandth of their distance apart.
fn floor_and_panes() -> Scene {
    let mut meshes = vec![pane(
        DVec3::new(0.0, -0.2, -450.0),
        [DVec3::X * 400.0, DVec3::new(0.0, 0.0, 449.8)],
        [0.2, 0.3, 0.4, 0.5],
    )];
    for (distance, turned, color) in [
        (600.06, 0.0, GREEN),
        (600.0, 0.4, RED),
        (60.006, 0.2, GREEN),
        (60.0, 0.6, RED),
    ] {
        meshes.push(tilted(distance, distance, turned, color));
    }
    scene(meshes)
}

/// Planes are close around a scene, so that most of it lies nearer than twice the near plane's distance, where near / w is
/// at least 1/2.
#[test]
fn by_1_over_w_every_method_keeps_apart_what_lies_close_to_the_near_plane() {
    let context = Context::headless().unwrap();
    let scene = example("soup", [80, 60]);
    let mut inverse = Renderer::new(&context, 80, 60).unwrap().with_inverse_w();
    let exact = inverse.render(&scene, &Method::Exact).unwrap();
    let hanging = exact.hanging.unwrap().drawn;
    let mut compared = 0;
    for entry in registry() {
        let here = entry.exact && entry.runs_on(context.driver());
        if !here || entry.method == Method::Exact {
            continue;
        }
        let frame = inverse.render(&scene, &entry.method).unwrap();
        assert_eq!(frame.stats.lost, Some(0), "{}", entry.name);
        // Colours in lists have 16 bits: 0.0015 for each channel.
        let bound = if frame.stats.a_buffer.is_some() {
            1.5e-3
        } else {
            F32
        };
        let off = Comparison::among(&frame.image, &exact.image, bound, |p| !hanging[p]).unwrap();
        assert!(off.max <= bound, "{}: {}", entry.name, off.max);
        compared += 1;
    }
    assert!(compared > 10, "{compared}");
}

#[test]
pub(crate) fn by_1_over_w_every_method_that_can_keeps_apart_what_window_depth_confuses() {
    let context = Context::headless().unwrap();
    let scene = floor_and_panes();
    let [width, height] = scene.size;
    let mut window = Renderer::new(&context, width, height).unwrap();
    let mut inverse = Renderer::new(&context, width, height)
        .unwrap()
        .with_inverse_w();
    assert_right(&window.render(&scene, &Method::Exact).unwrap(), &scene);
    for entry in registry() {
        let here = entry.exact && entry.runs_on(context.driver());
        if !here || entry.method == Method::Exact {
            continue;
        }
        // Colours in lists have 16 bits: 0.0015 for each channel.
        let bound = if entry.name.contains('-') && !entry.name.contains('+') {
            1e-5
        } else {
            2e-3
        };
        let off = |frame: &Frame| wrong_by(frame, &scene, bound).0;
        let by_window = window.render(&scene, &entry.method).unwrap();
        let by_inverse = inverse.render(&scene, &entry.method).unwrap();
        assert!(off(&by_window) > 10, "{}: {}", entry.name, off(&by_window));
        assert_eq!(off(&by_inverse), 0, "{}", entry.name);
        assert_eq!(by_inverse.stats.lost, Some(0), "{}", entry.name);
    }
}
