//! Slices through a volume with a cone in it (Carr et al. 2008, figures 1 and 3): the growth of the number of
//! iterations with the number of slices.
//!
//! Layer peeling takes one iteration per layer. Hybrid layer peeling peels only the cone, and coherent layer peeling
//! takes whole runs of slices, so their numbers do not grow.
//!
//! Writes one picture: the scene with 64 slices.
//!
//! `cargo run --example 06_slices_and_cone [FOLDER]`

use onionskin::low_level::edition::figures::carr::with_slices;
use onionskin::options::Variant;
use onionskin::report::Panels;
use onionskin::{Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 320, 240)?;
    let mut methods = vec![
        Method::LayerPeeling(Default::default()),
        Method::HybridLayerPeeling(Default::default()),
        Method::CoherentLayerPeeling(Variant::A.into()),
        Method::CoherentLayerPeeling(Variant::B.into()),
    ];
    let ideal = Method::IdealCoherentLayerPeeling(Default::default());
    if ideal.entry().runs_on(context.driver()) {
        methods.push(ideal);
    }

    print!("slices");
    methods.iter().for_each(|method| print!("  {method}"));
    println!();
    for count in [16, 32, 64] {
        let scene = scene(count)?;
        print!("{count:6}");
        for method in &methods {
            let stats = renderer.render(&scene, method)?.stats;
            let width = method.to_string().len();
            print!(
                "  {:>width$}",
                format!("{} ({})", stats.iterations, stats.geometry_passes)
            );
        }
        println!();
    }
    println!("iterations (geometry passes)");

    let frame = renderer.render(&scene(64)?, &methods[1])?;
    let path = example::output("06_slices_and_cone.png")?;
    let caption = format!(
        "hybrid layer peeling: {} iterations",
        frame.stats.iterations
    );
    Panels::new("64 slices of a volume with a cone in it (Carr et al. 2008, figures 1 and 3)")
        .picture(&frame.image, &caption)
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}

fn scene(count: u32) -> onionskin::Result<Scene> {
    let scene = Scene::load_at(example::scene("slices.toml"), Some([320, 240]))?;
    with_slices(scene, count, 16)
}
