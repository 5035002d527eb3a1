//! The ideal GPU of Carr et al. (2008, section 7): Algorithm 2 on a driver whose shaders read the framebuffer in order.
//!
//! As printed, a pixel that is done keeps its `z3`, and composites its last layer again in every further iteration. The
//! printed but unused `z2` suggests a tighter bound, which also saves iterations.
//!
//! Writes one picture: as amended on the left, as printed in the middle, their difference on the right.
//!
//! `cargo run --example 09_ideal_gpu [FOLDER]`

use onionskin::low_level::edition::figures::carr::ideal_rows;
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("knots.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;
    let Some(frames) = ideal_rows(&mut renderer, &scene, context.driver())? else {
        println!("skipped: this driver is no ideal GPU");
        return Ok(());
    };
    let exact = renderer.render(&scene, &Method::Exact)?;
    println!("submitted back to front    iterations  geometry passes  maximum error");
    for (name, frame) in &frames {
        let error = Comparison::new(&frame.image, &exact.image, 0.0)?.max;
        println!(
            "{name:<26} {:10}  {:15}  {error:13.1e}",
            frame.stats.iterations, frame.stats.geometry_passes
        );
    }

    let path = example::output("09_ideal_gpu.png")?;
    Panels::new("Algorithm 2 of Carr et al. 2008 on three interlocked knots")
        .picture(&frames[0].1.image, "as amended")
        .picture(
            &frames[1].1.image,
            "as printed: the last layer is composited again and again",
        )
        .difference(
            &frames[0].1.image,
            &frames[1].1.image,
            "difference of the two: largest channel",
        )?
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
