//! Scenes of the tests of the exact image.

use super::bounds::F32;
use glam::DVec3;
use onionskin::generate::{Soup, soup};
use onionskin::{Camera, Comparison, Context, Format, Method, Renderer, Scene};

/// How far a depth may be off: transform, division and interpolation are a handful of f32 roundings of 2^-24 each, of
/// the depth itself and of places in an image of `size` pixels, over which the depth changes by `slope` a pixel. That
/// corners are snapped to 1/256 of a pixel decides what is covered; depths are those of the corners where they were.
pub fn depth_bound(slope: f64, size: f64) -> f64 {
    8.0 * 2.0_f64.powi(-24) * (1.0 + slope * size)
}

pub fn soup_scene(seed: u64) -> Scene {
    let parameters = Soup {
        seed,
        count: 600,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [160, 120];
    scene
}

pub fn looking_down_z(distance: f64, fov: f64) -> Camera {
    Camera {
        eye: DVec3::Z * distance,
        target: DVec3::ZERO,
        up: DVec3::Y,
        fov,
        near: 0.1,
        far: 20.0,
    }
}

pub fn render(context: &Context, scene: &Scene, color: Format, method: Method) -> onionskin::Image {
    let [width, height] = scene.size;
    Renderer::new(context, width, height)
        .unwrap()
        .with_formats(color, Format::Depth32FStencil8)
        .render(scene, &method)
        .unwrap()
        .image
}

/// The method's image against the exact one.
pub fn error(context: &Context, scene: &Scene, method: Method) -> Comparison {
    let [image, exact] =
        [method, Method::Exact].map(|method| render(context, scene, Format::Rgba32F, method));
    Comparison::new(&image, &exact, F32).unwrap()
}
