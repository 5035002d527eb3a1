//! What is measured by the exact image's fragments: the ties that peeling loses, the painter, and coarser formats.

use crate::kit::bounds::F32;
use crate::kit::cast;
use crate::kit::exact_scenes::{
    depth_bound, error, looking_down_z, place_bound, render, soup_scene,
};
use crate::kit::lists::{Lists, captured, sorted, ties};
use glam::{DVec3, Vec3};
use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Context, Format, Mesh, Method, Renderer, Rgba, Scene, Vertex};

#[test]
fn what_peeling_loses_is_the_ties_of_a_soup_with_copies() {
    let context = Context::headless().unwrap();
    let mut scene = soup_scene(6);
    // Every fifth triangle once more, at the end.
    let copies: Vec<_> = scene.meshes[0]
        .triangles
        .iter()
        .step_by(5)
        .copied()
        .collect();
    scene.meshes[0].triangles.extend(copies);
    let (lost, ties) = lost_and_ties(&context, &scene);
    assert!(ties > 1000, "{ties}");
    assert_eq!(lost, ties);
}

#[test]
fn what_peeling_loses_is_the_ties_of_any_scene() {
    let context = Context::headless().unwrap();
    for name in ["knots", "soup", "teapot", "molecule"] {
        let path = format!("{}/examples/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::load_at(path, Some([240, 180])).unwrap();
        let (lost, ties) = lost_and_ties(&context, &scene);
        println!("{name}: {lost} lost, {ties} ties");
        assert_eq!(lost, ties, "{name}");
    }
}

#[test]
fn what_peeling_loses_of_the_bunny_are_depths_that_f32_cannot_tell_apart() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/data/bunny.toml");
    if !std::path::Path::new(path).exists() {
        println!("skipped: {path} is not there");
        return;
    }
    let context = Context::headless().unwrap();
    let scene = Scene::load(path).unwrap();
    let fragments = sorted(captured(&context, &scene, 2 << 20).unwrap());
    let frame = peel(&context, &scene, Compositing::OnTheFly);
    assert_eq!(frame.stats.lost, Some(ties(&fragments)));
    for pair in fragments.windows(2) {
        if ties(pair) == 1 {
            let pixel = [pair[0].x, scene.size[1] - 1 - pair[0].y];
            let found = [0, 1].map(|n| cast::depth_of(&scene, pair[n].order, pixel));
            println!("{pair:?}\nby rays: {found:?}");
            // Two triangles that do meet there: as far apart as each may be off.
            let [(a, slope_a), (b, slope_b)] = found;
            let place = place_bound(&context, f64::from(scene.size[0]));
            assert!((a - b).abs() <= depth_bound(slope_a, place) + depth_bound(slope_b, place));
            assert_ne!(pair[0].order, pair[1].order);
        }
    }
}

#[test]
fn the_painter_is_exact_where_triangles_can_be_sorted() {
    let context = Context::headless().unwrap();
    let mut scene = Scene::of("sheets", vec![shuffled_sheets()]);
    scene.size = [80, 60];
    scene.camera = looking_down_z(4.0, 40.0);
    assert!(error(&context, &scene, Method::Painter).max <= F32);
    assert!(error(&context, &scene, Method::Blend).max > 0.01);
}

#[test]
fn the_painter_is_wrong_where_triangles_go_through_each_other() {
    let context = Context::headless().unwrap();
    let mut scene = Scene::of("crossed", vec![crossed()]);
    scene.size = [80, 60];
    scene.camera = looking_down_z(4.0, 40.0);
    assert!(error(&context, &scene, Method::Painter).max > 0.1);
    let options = DepthPeelingOptions::default();
    assert!(error(&context, &scene, Method::DepthPeeling(options)).max <= F32);
}

#[test]
fn coarser_colors_are_off_by_their_own_steps_and_a_pixel_s_layers() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(2);
    let lists = Lists::of(&context, &scene);
    let exact = render(&context, &scene, Format::Rgba32F, Method::Exact);
    // The steps below 1. A rounding is off by half a step; but 8-bit blending may be off by a whole one.
    for (format, step) in [
        (Format::Rgba8, 1.0 / 255.0),
        (Format::Rgba16F, 2.0_f64.powi(-11)),
    ] {
        for compositing in [Compositing::OnTheFly, Compositing::KeepLayers] {
            let method = Method::DepthPeeling(DepthPeelingOptions {
                compositing,
                ..Default::default()
            });
            let image = render(&context, &scene, format, method);
            let mut worst: (f64, f64) = (0.0, 0.0);
            for ((a, b), list) in image.pixels.iter().zip(&exact.pixels).zip(&lists.pixels) {
                // A layer's colour, its alpha, and the blending are rounded, under the light that is left; what alpha
                // has gathered, the later layers and the background see: 3.5 steps a layer, and 1 for the background.
                let bound = step * (3.5 * list.len() as f64 + 1.0);
                let off = a.to_array().into_iter().zip(b.to_array());
                // Of these an order in which what is not a number is the largest.
                let off = off
                    .map(|(a, b)| f64::from(a - b).abs())
                    .max_by(f64::total_cmp)
                    .unwrap();
                assert!(
                    off <= bound,
                    "{format:?}, {compositing:?}: {off} of {bound}"
                );
                worst = (worst.0.max(off), worst.1.max(off / bound));
            }
            println!(
                "{format:?}, {compositing:?}: at most {} steps, {:.2} of the bound",
                worst.0 / step,
                worst.1
            );
            assert!(worst.0 > 0.5 * step, "the format is not the one asked for");
        }
    }
}

fn shuffled_sheets() -> Mesh {
    quads(&Quads {
        count: 12,
        order: SubmissionOrder::Shuffled,
        seed: 3,
        ..Quads::default()
    })
    .unwrap()
}

/// Two quads, each before the other in half of the image.
fn crossed() -> Mesh {
    let mut vertices = Vec::new();
    for (tilt, color) in [(0.8, [1.0, 0.0, 0.0]), (-0.8, [0.0, 1.0, 0.0])] {
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let [r, g, b] = color;
            vertices.push(Vertex {
                position: DVec3::new(x, y, x * tilt),
                normal: Vec3::Z,
                color: Rgba::new(r, g, b, 0.5),
            });
        }
    }
    let triangles = vec![[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    Mesh::new("crossed", vertices, triangles)
}

fn lost_and_ties(context: &Context, scene: &Scene) -> (u64, u64) {
    let frame = peel(context, scene, Compositing::OnTheFly);
    let fragments = sorted(captured(context, scene, u32::MAX).unwrap());
    assert_eq!(frame.stats.fragments, fragments.len() as u64);
    (frame.stats.lost.unwrap(), ties(&fragments))
}

fn peel(context: &Context, scene: &Scene, compositing: Compositing) -> onionskin::Frame {
    let [width, height] = scene.size;
    let options = DepthPeelingOptions {
        compositing,
        ..Default::default()
    };
    Renderer::new(context, width, height)
        .unwrap()
        .render(scene, &Method::DepthPeeling(options))
        .unwrap()
}
