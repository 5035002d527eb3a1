//! How does a frame's cost follow its depth complexity (Lindholm et al. 2015, figure 2)?
//!
//! The camera dollies to the molecule and back while every hundredth step changes what is shown. Every tenth step's
//! histogram is a bar; the lines are the fragments, the longest list and the time of a per-pixel linked list, each as a
//! ratio to frame 0's. The volumes are left out: what is counted and timed here is the geometry alone.
//!
//! `cargo run --release --example 20_figure_2_over_time [FOLDER]`

use onionskin::methods::{ABufferOptions, CountBy};
use onionskin::report::{Moment, save_series_csv, series};
use onionskin::scene::Animation;
use onionskin::{Context, Method, Renderer};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [256, 192];
const NAMES: [&str; 3] = ["fragments", "longest list", "time"];

fn main() -> onionskin::Result<()> {
    let animation = Animation::load_at(example::scene("molecule_fused.toml"), Some(SIZE))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let method = Method::ABuffer(ABufferOptions::DEFAULT);
    let mut moments = Vec::new();
    let mut first = None;
    for frame in (0..animation.path.frames).step_by(10) {
        let mut scene = animation.frame(frame)?;
        scene.volumes.clear();
        let complexity = renderer.complexity(&scene, CountBy::Blending)?;
        let ms = renderer.measure(&scene, &method, 3)?.stats.ms;
        let costs = [
            complexity.fragments() as f64,
            f64::from(complexity.max()),
            ms,
        ];
        let first = *first.get_or_insert(costs);
        let ratios = [0, 1, 2].map(|n| costs[n] / first[n]);
        moments.push(Moment::new(frame, &complexity, ratios.to_vec()));
    }
    let [svg, png] = series("molecule, dolly in and out", &NAMES, &moments)?;
    let path = example::output("20_figure_2_over_time.png")?;
    png.save(&path)?;
    svg.save(&path.with_extension("svg"))?;
    save_series_csv(&path.with_extension("csv"), &NAMES, &moments)?;
    let at = |frame: usize| moments[frame / 10].values.clone();
    println!(
        "frame 0 is 1; frame 100, as near as it gets: {:.2?}",
        at(100)
    );
    println!(
        "frame 200, far and with everything but volumes: {:.2?}",
        at(200)
    );
    println!("{}", path.display());
    Ok(())
}
