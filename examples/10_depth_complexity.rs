//! How many layers does each pixel have (Lindholm et al. 2015, figure 1)?
//!
//! Counts the molecule's fragments by additive blending and, as the paper does, by atomic counters. The counts agree.
//! Prints how steeply the histogram falls. Writes the depth complexity image, and the histogram's plot as SVG.
//!
//! `cargo run --example 10_depth_complexity [FOLDER]`

use onionskin::report::{Measure, Panels, PlotKind, plot};
use onionskin::{Context, CountBy, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("molecule.toml"), Some([640, 480]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 640, 480)?;
    let complexity = renderer.complexity(&scene, CountBy::Blending)?;
    let atomics = renderer.complexity(&scene, CountBy::Atomics)?;
    println!("blending and atomics agree: {}", complexity == atomics);

    let percent = |part: f64| part * 100.0;
    println!("fragments       {:8}", complexity.fragments());
    println!("most layers     {:8}", complexity.max());
    println!("median          {:8}", complexity.percentile(0.5));
    println!("8 or less       {:7.1}%", percent(complexity.part_up_to(8)));
    println!(
        "more than 17    {:7.1}%",
        percent(1.0 - complexity.part_up_to(17))
    );

    let svg = example::output("10_depth_complexity.svg")?;
    plot("molecule", &complexity, 1, PlotKind::Svg)?.save(&svg)?;
    let path = example::output("10_depth_complexity.png")?;
    let layers = Measure::of_counts(640, 480, &complexity.counts).inverted();
    Panels::new("Depth complexity of the molecule (Lindholm et al. 2015, figure 1)")
        .measure(layers, "layers at each pixel")
        .save(&path)?;
    println!("{}\n{}", path.display(), svg.display());
    Ok(())
}
