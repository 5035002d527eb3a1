//! How does a frame's cost follow its depth complexity (Lindholm et al. 2015, figure 2)?
//!
//! The camera dollies to the molecule and back. Every hundred frames the scene changes: at frame 100 the molecular
//! surface leaves; at frame 200 the volumes leave and the surface returns; at frame 300 the potential's isosurfaces
//! enter. The histogram of every tenth frame is a bar, in which the boxes of volumes count as in the paper. The lines
//! are the costs of a linked list with ppDP, each relative to frame 0. Counts follow the histogram. The time also has
//! the rays through volumes.
//!
//! `cargo run --release --example 20_figure_2_over_time [FOLDER]`

use onionskin::low_level::edition::figures::lindholm::figure_2::{NAMES, moments};
use onionskin::report::{save_series_csv, series};
use onionskin::{Animation, Context, Renderer};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [192, 144];
const TITLE: &str = "Layers and costs along a camera path (Lindholm et al. 2015, figure 2)";

fn main() -> onionskin::Result<()> {
    let animation = Animation::load_at(example::scene("molecule_fused.toml"), Some(SIZE))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let moments = moments(&mut renderer, &animation, 10, true)?;
    let [svg, png] = series(TITLE, &NAMES, &moments)?;
    let path = example::output("20_figure_2_over_time.png")?;
    png.save(&path)?;
    svg.save(&path.with_extension("svg"))?;
    save_series_csv(&path.with_extension("csv"), &NAMES, &moments)?;
    println!("frame  {}, frame 0 = 1", NAMES.join(", "));
    for moment in moments.iter().step_by(5) {
        println!("{:>5}  {:.2?}", moment.frame, moment.values);
    }
    println!("{}", path.display());
    Ok(())
}
