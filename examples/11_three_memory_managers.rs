//! What do the three memory managers allocate (Lindholm et al. 2015, figure 4)?
//!
//! FFB gives every pixel the room that the deepest pixel needs. DFB and PPLL give each pixel the room that it needs.
//! For that, DFB takes a prefix scan, and PPLL a link per fragment. The images are the same, bit for bit. With half of
//! its bytes as the budget, FFB renders in bands, and the image is still the same.
//!
//! Draws figure 4 from the fragments of a row of six pixels.
//!
//! `cargo run --example 11_three_memory_managers [FOLDER]`

use onionskin::options::{ABufferOptions, Manager};
use onionskin::report::memory_layout;
use onionskin::{Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("molecule.toml"), Some([640, 480]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 640, 480)?;

    println!("manager  bands  list memory  bytes a fragment  same image");
    let mut first = None;
    let mut fixed_bytes = 0;
    for (name, manager, in_bands) in [
        ("FFB", Manager::Ffb, false),
        ("DFB", Manager::Dfb, false),
        ("PPLL", Manager::Ppll, false),
        ("FFB", Manager::Ffb, true),
    ] {
        let options = ABufferOptions {
            manager,
            // Without a budget, bands may be cut for speed.
            budget: Some(if in_bands { fixed_bytes / 2 } else { u64::MAX }),
            ..ABufferOptions::default()
        };
        let frame = renderer.render(&scene, &Method::ABuffer(options))?;
        let Some(counts) = frame.stats.a_buffer else {
            continue;
        };
        if manager == Manager::Ffb {
            fixed_bytes = counts.list_bytes;
        }
        let first = first.get_or_insert_with(|| frame.image.clone());
        println!(
            "{name:<8} {:>5} {:>8.1} MiB {:>17.1}  {}",
            counts.bands,
            counts.list_bytes as f64 / f64::from(1 << 20),
            counts.list_bytes as f64 / frame.stats.fragments as f64,
            if *first == frame.image { "yes" } else { "no" }
        );
    }

    let scene = Scene::load_at(example::scene("knots.toml"), Some([6, 5]))?;
    let fragments = example::fragments(&context, &scene)?;
    let row = fragments.iter().filter(|fragment| fragment.y == 2);
    let pixels: Vec<u32> = row.map(|fragment| fragment.x).collect();
    let title = "Three memory managers (Lindholm et al. 2015, figure 4): six pixels of the knots";
    let figure = memory_layout(title, 6, &pixels);
    for ending in ["svg", "png"] {
        let path = example::output(&format!("11_three_memory_managers.{ending}"))?;
        figure.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
