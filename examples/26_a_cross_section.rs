//! Depth peeling in a cross section of the view volume (Everitt 2001, figure 4): each pass strips a layer away.
//!
//! Cuts through the three knots, in the column of pixels that has most fragments. The nearest surface of each pixel is
//! layer 0. Each layer's depths vary, and the pieces are no whole polygons.
//!
//! Writes one figure, as SVG and as PNG.
//!
//! `cargo run --example 26_a_cross_section [FOLDER]`

use onionskin::low_level::edition::figures::deepest_column;
use onionskin::report::CrossSection;
use onionskin::{Context, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [560, 420];

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("knots.toml"), Some(SIZE))?;
    let context = Context::headless()?;
    let column = deepest_column(&context, &scene)?;
    for layer in 0..4 {
        let samples = column.iter().filter(|pixel| pixel.len() > layer).count();
        println!("layer {layer}: {samples:4} samples");
    }
    let title = "A vertical cut through three knots, seen from the left (Everitt 2001, figure 4)";
    let figure = CrossSection::new(title, 3, &column);
    for ending in ["svg", "png"] {
        let path = example::output(&format!("26_a_cross_section.{ending}"))?;
        figure.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
