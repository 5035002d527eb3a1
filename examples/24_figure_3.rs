//! Slices through a volume with a cone in it, to 384 slices: figure 3 of Carr, Měch and Miller (2008) as a table and a plot.
//!
//! Layer peeling's iterations grow with the slices, hybrid layer peeling's stay at 3. The paper has coherent layer peeling
//! constant, too. It is so up to 192 slices; then the 128 surfaces that an iteration can count at most begin to show.
//!
//! Writes one plot, as PNG and as SVG: iterations, and the time of a frame.
//!
//! `cargo run --release --example 24_figure_3 [FOLDER]`

use onionskin::generate::{Slices, SubmissionOrder, slices};
use onionskin::options::Variant;
use onionskin::report::{Curves, Plot, convergence};
use onionskin::{Context, Method, Renderer, Scene, Stats};

#[path = "common/example.rs"]
mod example;

/// Small, because layer peeling draws each of 384 slices some 800 times.
const SIZE: [u32; 2] = [32, 24];
const SLICES: [u32; 6] = [16, 32, 64, 128, 256, 384];

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let methods = [
        Method::LayerPeeling(Default::default()),
        Method::HybridLayerPeeling(Default::default()),
        Method::CoherentLayerPeeling(Variant::A.into()),
        Method::CoherentLayerPeeling(Variant::B.into()),
    ];
    println!("slices      layer peeling             hybrid         coherent A         coherent B");
    let mut rows: Vec<Vec<Stats>> = Vec::new();
    for count in SLICES {
        let scene = scene(count)?;
        // The counts are the same in every frame, and the long frames' times differ little.
        let frames = if count > 128 { 1 } else { 3 };
        let mut row = Vec::new();
        for method in &methods {
            row.push(renderer.measure(&scene, method, frames)?.stats);
        }
        print!("{count:6}");
        for stats in &row {
            let cell = format!("{} it, {} g", stats.iterations, stats.geometry_passes);
            print!("{cell:>19}");
        }
        println!();
        rows.push(row);
    }
    let last = &rows[rows.len() - 1];
    println!(
        "times at {} slices: layer peeling / hybrid {:.0} (the paper at 256: 52), coherent A / hybrid {:.0} (about 6)",
        SLICES[SLICES.len() - 1],
        last[0].ms / last[1].ms,
        last[2].ms / last[1].ms
    );

    let curve = |name: &str, method: usize, value: fn(&Stats) -> f64| {
        let values = rows.iter().map(|row| value(&row[method])).collect();
        (name.to_owned(), values)
    };
    let iterations = |stats: &Stats| f64::from(stats.iterations);
    let plots = convergence(
        "Figure 3 of Carr et al. 2008, on this renderer",
        ("slices", &SLICES.map(f64::from)),
        &Curves {
            of_what: "iterations".into(),
            curves: vec![
                curve("layer peeling", 0, iterations),
                curve("coherent layer peeling A", 2, iterations),
                curve("hybrid layer peeling", 1, iterations),
            ],
        },
        &Curves {
            of_what: "milliseconds".into(),
            curves: vec![
                curve("layer peeling, ms", 0, |stats| stats.ms),
                curve("coherent layer peeling A, ms", 2, |stats| stats.ms),
            ],
        },
    )?;
    for plot in plots {
        let ending = match plot {
            Plot::Svg(_) => "svg",
            Plot::Png(_) => "png",
        };
        let path = example::output(&format!("24_figure_3.{ending}"))?;
        plot.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}

fn scene(count: u32) -> onionskin::Result<Scene> {
    let mut scene = Scene::load_at(example::scene("slices.toml"), Some(SIZE))?;
    scene.meshes[0] = slices(&Slices {
        count,
        cells: 2,
        alpha: 12.8 / count as f32,
        order: SubmissionOrder::FrontToBack,
        ..Slices::default()
    })?;
    scene.meshes[0].sorted = true;
    Ok(scene)
}
