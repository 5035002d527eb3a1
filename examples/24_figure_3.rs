//! Slices through a volume with a cone in it, to 384 slices: figure 3 of Carr, Měch and Miller (2008) as a table and a plot.
//!
//! Layer peeling's iterations grow with the slices, hybrid layer peeling's stay at 3. The paper has coherent layer peeling
//! constant, too. It is so up to 192 slices; then the 128 surfaces that an iteration can count at most begin to show.
//!
//! Writes one plot, as PNG and as SVG: iterations, and the time of a frame.
//!
//! `cargo run --release --example 24_figure_3 [FOLDER]`

use onionskin::low_level::edition::figures::carr::figure_3::{SIZE, counts, rows};
use onionskin::report::{Curves, Plot, convergence};
use onionskin::{Context, Renderer, Scene, Stats};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let scene = Scene::load_at(example::scene("slices.toml"), Some(SIZE))?;
    let slices = counts(false);
    let rows = rows(&mut renderer, &scene, slices, true)?;
    println!("slices      layer peeling             hybrid         coherent A         coherent B");
    for (count, row) in slices.iter().zip(&rows) {
        print!("{count:6}");
        for stats in row {
            let cell = format!("{} it, {} g", stats.iterations, stats.geometry_passes);
            print!("{cell:>19}");
        }
        println!();
    }
    let last = &rows[rows.len() - 1];
    println!(
        "times at {} slices: layer peeling / hybrid {:.0} (the paper at 256: 52), coherent A / hybrid {:.0} (about 6)",
        slices[slices.len() - 1],
        last[0].ms / last[1].ms,
        last[2].ms / last[1].ms
    );

    let curve = |name: &str, method: usize, value: fn(&Stats) -> f64| {
        let values = rows.iter().map(|row| value(&row[method])).collect();
        (name.to_owned(), values)
    };
    let iterations = |stats: &Stats| f64::from(stats.iterations);
    let across: Vec<f64> = slices.iter().copied().map(f64::from).collect();
    let plots = convergence(
        "Figure 3 of Carr et al. 2008, on this renderer",
        ("slices", &across),
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
