//! Scenes of the tests of the exact image.

use super::bounds::F32;
use glam::DVec3;
use onionskin::generate::{Soup, soup};
use onionskin::{Camera, Comparison, Context, Format, Method, Renderer, Scene};

/// How far a place in an image of `size` pixels may be off: a handful of f32 roundings of 2^-24 each, and what a driver moves
/// corners before it interpolates between them. Llvmpipe snaps them to 1/256 of a pixel only to decide what is covered.
/// Others do so before, and a corner moves by half a step along each axis.
pub fn place_bound(context: &Context, size: f64) -> f64 {
    let snapped = match context.driver().quirks().interpolates_true_corners {
        true => 0.0,
        false => f64::sqrt(0.5) / 256.0,
    };
    8.0 * 2.0_f64.powi(-24) * size + snapped
}

/// How far a depth may be off that changes by `slope` a pixel: transform, division and interpolation are a handful of f32
/// roundings, too, of the depth itself.
pub fn depth_bound(slope: f64, place: f64) -> f64 {
    8.0 * 2.0_f64.powi(-24) + slope * place
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
