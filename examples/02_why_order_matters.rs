//! Why order matters (Everitt 2001, figure 1).
//!
//! Three interlocked knots are blended in their order of submission, and peeled. No order of whole knots is right,
//! because each knot lies partly before and partly behind the others.
//!
//! Writes one picture: the peeled image on the left, the blended one in the middle, and their difference on the right.
//!
//! `cargo run --example 02_why_order_matters [FOLDER]`

use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("knots.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;

    let exact = renderer.render(&scene, &Method::Exact)?;
    let peeled = renderer.render(&scene, &Method::DepthPeeling(Default::default()))?;
    let blended = renderer.render(&scene, &Method::Blend)?;
    for frame in [&peeled, &blended] {
        let error = Comparison::new(&frame.image, &exact.image, 1.0 / 255.0)?;
        println!(
            "{:<14} maximum error {:.6}, {} of {} pixels off by more than 1/255",
            frame.stats.method,
            error.max,
            error.over,
            frame.image.pixels.len()
        );
    }

    let path = example::output("02_why_order_matters.png")?;
    Panels::new("Why order matters: three interlocked knots (Everitt 2001, figure 1)")
        .picture(&peeled.image, "depth peeling: right")
        .picture(&blended.image, "blended in the order of submission: wrong")
        .difference(
            &peeled.image,
            &blended.image,
            "difference of the two: largest channel",
        )?
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
