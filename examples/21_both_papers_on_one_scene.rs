//! One scene by both papers: rays cast between the fragments of a list (Lindholm et al. 2015, section 6), and the same
//! volumes as sorted slices next to peeled surfaces (Carr et al. 2008, Algorithm 1). How many slices does it take?
//!
//! A slice stands for a whole slab. If a surface is inside of a slab, or a ray enters a volume there, at most half of
//! the slab is on the wrong side. So twice as many slices halve the difference. The iterations of hybrid layer peeling
//! stay those of the surfaces. Layer peeling peels slices like surfaces, so its iterations grow with their number.
//!
//! Writes a plot, and a picture of 12 slices, of 96 slices, and of rays.
//!
//! `cargo run --release --example 21_both_papers_on_one_scene [FOLDER]`

use onionskin::low_level::edition::figures::lindholm::slices_against_rays;
use onionskin::report::{Curves, Panels, convergence};
use onionskin::{Context, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [200, 150];
const COUNTS: [u32; 6] = [16, 32, 64, 128, 256, 512];
/// With more slices, layer peeling takes minutes.
const MOST_FOR_LAYERS: u32 = 64;

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let scene = Scene::load_at(example::scene("fog.toml"), Some(SIZE))?;
    let (_, rows) = slices_against_rays(&context, &scene, &COUNTS, MOST_FOR_LAYERS)?;
    println!("slices  rms difference  largest  iterations: hybrid  layer peeling");
    for row in &rows {
        let of_layers = row.of_layers.map_or("not run".into(), |it| it.to_string());
        println!(
            "{:>6}  {:>14.1e}  {:>7.1e}  {:>18}  {of_layers:>13}",
            row.count, row.off.rms, row.off.max, row.iterations
        );
    }
    let max = rows.iter().map(|row| row.off.max).collect();
    let rms = rows.iter().map(|row| row.off.rms).collect();
    let hybrids = rows.iter().map(|row| f64::from(row.iterations)).collect();
    let layers = rows
        .iter()
        .filter_map(|row| row.of_layers.map(f64::from))
        .collect();
    let error = Curves {
        of_what: "difference from the fused image".into(),
        curves: vec![
            ("largest difference".into(), max),
            ("rms difference".into(), rms),
        ],
    };
    let iterations = Curves {
        of_what: "iterations".into(),
        curves: vec![
            ("iterations of hybrid layer peeling".into(), hybrids),
            ("iterations of layer peeling".into(), layers),
        ],
    };
    let caption = "two volumes and a ring: slices against rays";
    let counts = COUNTS.map(f64::from);
    let [svg, png] = convergence(caption, ("slices", &counts), &error, &iterations)?;
    let path = example::output("21_slices_against_rays.png")?;
    png.save(&path)?;
    svg.save(&path.with_extension("svg"))?;

    let scene = Scene::load_at(example::scene("fog.toml"), Some([320, 240]))?;
    let mut sheet = Panels::new(
        "Two volumes and a ring: slices (Carr et al. 2008), rays (Lindholm et al. 2015)",
    );
    let (rays, rows) = slices_against_rays(&context, &scene, &[12, 96], 0)?;
    for row in &rows {
        sheet = sheet.picture(&row.image, &format!("{} slices", row.count));
    }
    let path = example::output("21_both_papers_on_one_scene.png")?;
    sheet.picture(&rays, "rays").save(&path)?;
    println!("{}", path.display());
    Ok(())
}
