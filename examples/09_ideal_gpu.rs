//! The ideal GPU of Carr et al. (2008, section 7): Algorithm 2 on a driver whose shaders read the framebuffer in order.
//!
//! As printed, a pixel that is done keeps its `z3`, and composites its last layer again in every further iteration. The
//! printed but unused `z2` suggests a tighter bound, which also saves iterations.
//!
//! Writes one picture: as amended on the left, as printed in the middle, their difference on the right.
//!
//! `cargo run --example 09_ideal_gpu [FOLDER]`

use onionskin::options::{CoherentOptions, IdealOptions, Reading, TriangleSort, Variant};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("knots.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;
    let ideal = IdealOptions {
        sorting: TriangleSort::Reversed(1024),
        ..IdealOptions::default()
    };
    let entry = Method::IdealCoherentLayerPeeling(ideal).entry();
    if !entry.runs_on(context.driver()) {
        println!(
            "skipped: this driver has neither {}",
            entry.needs.join(" nor ")
        );
        return Ok(());
    }
    let exact = renderer.render(&scene, &Method::Exact)?;
    let coherent = |variant| {
        Method::CoherentLayerPeeling(CoherentOptions {
            sorting: ideal.sorting,
            ..CoherentOptions::from(variant)
        })
    };
    let ideal = |reading, tight_bound| {
        Method::IdealCoherentLayerPeeling(IdealOptions {
            reading,
            tight_bound,
            ..ideal
        })
    };
    let mut frames = Vec::new();
    println!("submitted back to front    iterations  geometry passes  maximum error");
    for (name, method) in [
        ("Algorithm 2", ideal(Reading::Amended, false)),
        ("Algorithm 2, as printed", ideal(Reading::AsPrinted, false)),
        ("Algorithm 2, tight bound", ideal(Reading::Amended, true)),
        ("coherent, variant A", coherent(Variant::A)),
        ("coherent, variant B", coherent(Variant::B)),
        ("layer peeling", Method::LayerPeeling(Default::default())),
    ] {
        let frame = renderer.render(&scene, &method)?;
        let error = Comparison::new(&frame.image, &exact.image, 0.0)?.max;
        println!(
            "{name:<26} {:10}  {:15}  {error:13.1e}",
            frame.stats.iterations, frame.stats.geometry_passes
        );
        frames.push(frame);
    }

    let path = example::output("09_ideal_gpu.png")?;
    Panels::new("Algorithm 2 of Carr et al. 2008 on three interlocked knots")
        .picture(&frames[0].image, "as amended")
        .picture(
            &frames[1].image,
            "as printed: the last layer is composited again and again",
        )
        .difference(
            &frames[0].image,
            &frames[1].image,
            "difference of the two, 0 to 1",
        )?
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
