//! A headless context and one triangle.
//!
//! It needs no window, no display and no GPU: the context comes from EGL's surfaceless platform or from OSMesa. The
//! triangle's three corners are red, green and blue. It is half transparent, over white. The picture has no caption: it
//! is the image as a renderer leaves it.
//!
//! `cargo run --example 01_first_light [FOLDER]`

use glam::{DVec3, Vec3};
use onionskin::{Camera, Context, Mesh, Method, Renderer, Rgba, Scene, Vertex};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    println!(
        "{}\n{}",
        context.driver().renderer,
        context.driver().version_text
    );

    let corner = |x, y, [r, g, b]: [f32; 3]| Vertex {
        position: DVec3::new(x, y, 0.0),
        normal: Vec3::Z,
        color: Rgba::new(r, g, b, 0.5),
    };
    let vertices = vec![
        corner(-1.0, -0.8, [1.0, 0.0, 0.0]),
        corner(1.0, -0.8, [0.0, 1.0, 0.0]),
        corner(0.0, 0.9, [0.0, 0.0, 1.0]),
    ];
    let triangle = Mesh {
        name: "triangle".into(),
        vertices,
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let scene = Scene {
        name: "first light".into(),
        size: [512, 512],
        background: [1.0; 3],
        camera: Camera {
            eye: DVec3::Z * 3.0,
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov: 45.0,
            near: 1.0,
            far: 5.0,
        },
        meshes: vec![triangle],
        volumes: Vec::new(),
        notices: Vec::new(),
    };

    let mut renderer = Renderer::new(&context, 512, 512)?;
    let frame = renderer.render(&scene, &Method::DepthPeeling(Default::default()))?;
    println!("{}", frame.stats);

    let path = example::output("01_first_light.png")?;
    frame.image.save(&path)?;
    println!("{}", path.display());
    Ok(())
}
