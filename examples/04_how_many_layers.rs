//! How many layers are enough (Everitt 2001, the second figure 5)?
//!
//! The teapot over a plane after one, two, three and four peels, with the error of each against the exact image.
//! Everitt finds three layers "good enough".
//!
//! Writes one picture: one and two layers above, three and four layers below.
//!
//! `cargo run --example 04_how_many_layers [FOLDER]`

use onionskin::options::DepthPeelingOptions;
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("teapot.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;
    let exact = renderer.render(&scene, &Method::Exact)?;

    println!("layers  fragments left  maximum error  rms error");
    let title = "How many layers are enough? (Everitt 2001, the second figure 5)";
    let mut sheet = Panels::new(title).columns(2);
    for maximum_number_of_peels in 1..=4 {
        let options = DepthPeelingOptions {
            maximum_number_of_peels,
            ..Default::default()
        };
        let frame = renderer.render(&scene, &Method::DepthPeeling(options))?;
        let error = Comparison::new(&frame.image, &exact.image, 0.0)?;
        let left = frame.stats.lost.unwrap_or_default();
        println!(
            "{maximum_number_of_peels:6} {left:15} {:14.4} {:10.5}",
            error.max, error.rms
        );
        let caption = format!(
            "layers: {maximum_number_of_peels}, rms error {:.5}",
            error.rms
        );
        sheet = sheet.picture(&frame.image, &caption);
    }

    let path = example::output("04_how_many_layers.png")?;
    sheet.save(&path)?;
    println!("{}", path.display());
    Ok(())
}
