//! The order of submission and coherent layer peeling: the image does not depend on it, the number of iterations does.
//!
//! The triangles of the molecule's surface and ribbon are sorted front to back, in the files' order, shuffled, and
//! sorted back to front.
//!
//! Writes one picture: the molecule in each order.
//!
//! `cargo run --example 07_sorted_shuffled_reversed [FOLDER]`

use onionskin::options::{CoherentOptions, TriangleSort, Variant};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let size = [256, 192];
    let mut scene = Scene::load_at(example::scene("molecule.toml"), Some(size))?;
    // In the order of the scene file: ligand, ribbon, two isosurfaces, surface.
    scene.meshes = vec![scene.meshes[1].clone(), scene.meshes[4].clone()];
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, size[0], size[1])?;
    let exact = renderer.render(&scene, &Method::Exact)?;
    let layers = renderer
        .render(&scene, &Method::LayerPeeling(Default::default()))?
        .stats;
    println!(
        "layer peeling   {:4} iterations {:4} geometry passes",
        layers.iterations, layers.geometry_passes
    );

    let mut shuffled = scene.clone();
    for mesh in &mut shuffled.meshes {
        *mesh = mesh.shuffled(7);
    }
    let title = "Coherent layer peeling of the molecule, submitted in four orders";
    let mut sheet = Panels::new(title).columns(2);
    for (name, scene, sorting) in [
        ("sorted", &scene, TriangleSort::Buckets(4096)),
        ("as in the files", &scene, TriangleSort::Submission),
        ("shuffled", &shuffled, TriangleSort::Submission),
        ("back to front", &scene, TriangleSort::Reversed(4096)),
    ] {
        let method = Method::CoherentLayerPeeling(CoherentOptions {
            sorting,
            ..Variant::B.into()
        });
        let frame = renderer.render(scene, &method)?;
        let error = Comparison::new(&frame.image, &exact.image, 0.0)?.max;
        println!(
            "{name:<15} {:4} iterations {:4} geometry passes, maximum error {error:.1e}",
            frame.stats.iterations, frame.stats.geometry_passes
        );
        let caption = format!("{name}: {} iterations", frame.stats.iterations);
        sheet = sheet.picture(&frame.image, &caption);
    }

    let path = example::output("07_sorted_shuffled_reversed.png")?;
    sheet.save(&path)?;
    println!("{}", path.display());
    Ok(())
}
