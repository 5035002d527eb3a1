//! What do the three memory managers allocate (Lindholm et al. 2015, figure 4)?
//!
//! FFB gives every pixel the room that the deepest pixel needs. DFB and PPLL give each pixel the room that it needs.
//! For that, DFB takes a prefix scan, and PPLL a link per fragment. The images are the same, bit for bit. With half of
//! its bytes as the budget, FFB renders in bands, and the image is still the same.
//!
//! Draws figure 4 from the fragments of a row of six pixels.
//!
//! `cargo run --example 11_three_memory_managers [FOLDER]`

use onionskin::low_level::edition::figures::lindholm::figure_4::{SIX, managers, six_pixels};
use onionskin::report::memory_layout;
use onionskin::{Context, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("molecule.toml"), Some([640, 480]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 640, 480)?;

    println!("manager  bands  list memory  bytes a fragment  same image");
    for row in managers(&mut renderer, &scene)? {
        println!(
            "{:<8} {:>5} {:>8.1} MiB {:>17.1}  {}",
            row.name,
            row.bands,
            row.bytes as f64 / f64::from(1 << 20),
            row.each,
            if row.same_image { "yes" } else { "no" }
        );
    }

    let scene = Scene::load_at(example::scene("knots.toml"), Some(SIX))?;
    let title = "Three memory managers (Lindholm et al. 2015, figure 4): six pixels of the knots";
    let figure = memory_layout(title, SIX[0], &six_pixels(&context, &scene)?);
    for ending in ["svg", "png"] {
        let path = example::output(&format!("11_three_memory_managers.{ending}"))?;
        figure.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
