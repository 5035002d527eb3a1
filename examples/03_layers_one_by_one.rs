//! The layers one by one (Everitt 2001, figure 3).
//!
//! A teapot over a plane: outside red, inside green, the plane blue. Layer 0 is the nearest surface at each pixel,
//! layer 1 the second nearest, and so on. Each layer has fewer samples than the one before, and layer 2 is mostly
//! plane, in the shape of a teapot.
//!
//! Writes one picture: layers 0 and 1 above, layers 2 and 3 below. Surfaces are drawn opaque, so that they can be seen.
//!
//! `cargo run --example 03_layers_one_by_one [FOLDER]`

use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::report::{Panels, opaque};
use onionskin::{Context, Method, Renderer, Rgba, Scene};

#[path = "common/example.rs"]
mod example;

/// As the scene file has them, before they are lit.
const OUTSIDE: [f32; 3] = [0.95, 0.1, 0.05];
const INSIDE: [f32; 3] = [0.05, 0.85, 0.15];
const PLANE: [f32; 3] = [0.15, 0.25, 0.95];

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("teapot.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let options = DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..Default::default()
    };
    let frame =
        Renderer::new(&context, 512, 384)?.render(&scene, &Method::DepthPeeling(options))?;

    let mut sheet = Panels::new("The layers one by one (Everitt 2001, figure 3)").columns(2);
    for (number, layer) in frame.layers.iter().enumerate() {
        let samples = layer.depth.iter().filter(|&&depth| depth < 1.0).count();
        println!("layer {number}: {samples:6} samples");
        if number < 4 {
            let caption = format!("layer {number}: {samples} samples");
            sheet = sheet.picture(&opaque(layer), &caption);
        }
    }
    let path = example::output("03_layers_one_by_one.png")?;
    sheet
        .key(Rgba::opaque(OUTSIDE), "outside")
        .key(Rgba::opaque(INSIDE), "inside")
        .key(Rgba::opaque(PLANE), "plane")
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
