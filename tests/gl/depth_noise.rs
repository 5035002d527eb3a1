//! How far a rasteriser's depths are off, against what the oracle allows for.

use glam::{DVec3, Vec3};
use onionskin::low_level::gl::CapturedFragment;
use onionskin::low_level::oracle::{DepthBuffer, surfaces::Surfaces};
use onionskin::{Camera, Context, Mesh, Rgba, Scene, Vertex};

use crate::kit::chance::Chance;
use crate::kit::lists::captured;
use crate::kit::render::example;

/// Triangles of random places and directions, whose third corner is close to the line between the others.
fn slivers(seed: u64) -> Scene {
    let mut chance = Chance::new(seed);
    let mut vertices = Vec::new();
    for _ in 0..300 {
        let [a, b] = [0, 1].map(|_| chance.vector(1.0));
        let c = a.lerp(b, chance.unit()) + chance.vector(0.02);
        vertices.extend([a, b, c].map(|position| Vertex {
            position,
            normal: Vec3::Z,
            color: Rgba::new(1.0, 1.0, 1.0, 0.5),
        }));
    }
    let triangles = (0..300).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mut scene = Scene::of("slivers", vec![Mesh::new("slivers", vertices, triangles)]);
    scene.size = [640, 480];
    scene.camera = Camera::looking(DVec3::new(0.0, 0.0, 4.0), DVec3::NEG_Z);
    scene
}

/// The depths that a rasteriser gives to all fragments of a few scenes, against those of the rays: none is farther off than
/// the noise of the depth buffer. One scene is the cone of slivers through Carr's slices.
#[test]
fn no_fragment_s_depth_is_off_by_more_than_the_noise() {
    let context = Context::headless().unwrap();
    let interpolates_true_corners = context.driver().quirks().interpolates_true_corners;
    let examples = [
        ("slices", [512, 384]),
        ("teapot", [320, 240]),
        ("knots", [320, 240]),
        ("soup", [320, 240]),
        ("molecule", [160, 120]),
    ];
    let scenes = examples.map(|(name, size)| example(name, size));
    let (mut beside, mut in_slivers, mut least) = (0, 0, f64::INFINITY);
    for mut scene in scenes.into_iter().chain([1, 2].map(slivers)) {
        scene.meshes.retain(|mesh| !mesh.sorted);
        let bounds = scene.bounds().expect("meshes");
        scene.camera = scene.camera.close_around(bounds);
        let surfaces = Surfaces::of(&scene, scene.size);
        let float = DepthBuffer::float(&scene.camera, scene.size);
        let buffer = match interpolates_true_corners {
            true => float,
            false => float.with_snapped_corners(),
        };
        let fragments = captured(&context, &scene, 1 << 20).unwrap();
        assert!(
            fragments.len() > 10_000,
            "{}: {}",
            scene.name,
            fragments.len()
        );
        for CapturedFragment {
            x, y, depth, order, ..
        } in fragments
        {
            let at = surfaces.meeting([x, y], order);
            let off = (f64::from(depth) - buffer.depth(at.inverse)).abs();
            let noise = buffer.noise_at(&at);
            assert!(
                off <= noise,
                "{} {x} {y}: {off:e} > {noise:e}, {at:?}",
                scene.name
            );
            least = least.min(noise / off);
            // Without what the shape adds, the noise would be too little.
            let is_more = off > buffer.noise(at.inverse, at.slope);
            beside += usize::from(is_more && at.beside);
            in_slivers += usize::from(is_more && !at.beside);
        }
    }
    println!("noise is at least {least} of what depths are off; more than without the shape:");
    println!("{beside} beside their triangles, {in_slivers} in slivers");
    if interpolates_true_corners {
        assert!(beside > 100 && in_slivers > 1000);
    }
}
