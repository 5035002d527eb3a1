//! Coplanar boxes under every method.
//!
//! The boxes touch. Where two of them meet, each has a face at exactly the same depth. Everitt peels "each unique
//! depth", so plain depth peeling keeps one of the two faces. Other methods keep both, in the order of submission. The
//! detector does not ask a method what it has lost. It renders the boxes as grey glass, and counts the panes by the
//! light that comes through.
//!
//! Writes one picture: the exact image, the image of plain depth peeling, and the places where that lacks fragments.
//!
//! `cargo run --example 15_coplanar_boxes [FOLDER]`

use glam::{DVec3, Vec3};
use onionskin::low_level::methods::coplanar::shown;
use onionskin::report::{Measure, Panels};
use onionskin::{
    Camera, Comparison, Context, Format, Mesh, Method, Renderer, Rgba, Scene, Shading, Vertex,
    registry,
};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [400, 300];

fn main() -> onionskin::Result<()> {
    let scene = boxes();
    let context = Context::headless()?;
    let exact = Renderer::new(&context, SIZE[0], SIZE[1])?.render(&scene, &Method::Exact)?;
    println!("{} fragments", exact.stats.fragments);
    println!("method                    missing  doubled  lost by its own count  maximum error");
    let driver = context.driver();
    for entry in registry() {
        if !entry.runs_on(driver) {
            println!("{:<24} needs {}", entry.name, entry.needs.join(" or "));
            continue;
        }
        let method = entry.method;
        let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
        let frame = renderer.render(&scene, &method)?;
        drop(renderer);
        let found = shown(&context, &scene, &method, Format::Depth32FStencil8)?;
        let error = Comparison::new(&frame.image, &exact.image, 0.0)?;
        let own = frame
            .stats
            .lost
            .map_or("not counted".into(), |lost| lost.to_string());
        println!(
            "{:<24} {:8} {:8} {own:>22} {:14.6}",
            entry.name,
            found.missing(),
            found.doubled(),
            error.max
        );
    }

    let plain: Method = "depth-peeling".parse()?;
    let image = Renderer::new(&context, SIZE[0], SIZE[1])?
        .render(&scene, &plain)?
        .image;
    let found = shown(&context, &scene, &plain, Format::Depth32FStencil8)?;
    let path = example::output("15_coplanar_boxes.png")?;
    let pairs = found.submitted.iter().zip(&found.shown);
    let missing: Vec<u32> = pairs.map(|(s, shown)| s.saturating_sub(*shown)).collect();
    Panels::new("Three boxes that touch: two faces at exactly one depth")
        .picture(&exact.image, "exact")
        .picture(&image, "plain depth peeling keeps one of the two")
        .measure(
            Measure::of_counts(SIZE[0], SIZE[1], &missing),
            "fragments missing at each pixel",
        )
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// Three boxes in a row, each touching the next.
fn boxes() -> Scene {
    let colors = [[0.85, 0.2, 0.15], [0.15, 0.6, 0.25], [0.2, 0.35, 0.9]];
    let meshes = (0..3).zip(colors).map(|(n, [r, g, b])| {
        let left = f64::from(n) - 1.5;
        let (low, high) = (
            DVec3::new(left, -0.5, -0.5),
            DVec3::new(left + 1.0, 0.5, 0.5),
        );
        a_box(low, high, Rgba::new(r, g, b, 0.35))
    });
    Scene {
        name: "boxes".into(),
        size: SIZE,
        background: [1.0; 3],
        camera: Camera {
            eye: DVec3::new(2.6, 1.7, 3.4),
            target: DVec3::new(0.0, -0.05, 0.0),
            up: DVec3::Y,
            fov: 38.0,
            near: 1.0,
            far: 10.0,
        },
        meshes: meshes.collect(),
        volumes: Vec::new(),
        notices: Vec::new(),
    }
}

fn a_box(low: DVec3, high: DVec3, color: Rgba) -> Mesh {
    let corner = |n: u32| {
        let at = |bit: u32, low: f64, high: f64| if n >> bit & 1 == 0 { low } else { high };
        Vertex {
            position: DVec3::new(
                at(0, low.x, high.x),
                at(1, low.y, high.y),
                at(2, low.z, high.z),
            ),
            normal: Vec3::Z,
            color,
        }
    };
    // Left, right, bottom, top, back, front. Opposite faces have the same diagonal, so that faces that touch are equal.
    let faces = [
        [0, 2, 6, 4],
        [1, 3, 7, 5],
        [0, 1, 5, 4],
        [2, 3, 7, 6],
        [0, 1, 3, 2],
        [4, 5, 7, 6],
    ];
    let triangles = faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Mesh {
        name: "box".into(),
        vertices: (0..8).map(corner).collect(),
        triangles: triangles.collect(),
        shading: Shading::Flat,
        ..Mesh::default()
    }
    .with_face_normals()
}
