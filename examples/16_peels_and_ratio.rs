//! VTK's two options on a real mesh: the maximum number of peels, and the occlusion ratio.
//!
//! The molecule is peeled once, twice, and so on until nothing is left; each row has the error and the time. Then it is
//! peeled with occlusion ratios from 0 up. Dual peeling, which takes two layers per peel, runs beside both.
//!
//! Writes one picture: 1, 4 and 12 peels above, and the same with dual peeling below.
//!
//! `cargo run --release --example 16_peels_and_ratio [FOLDER]`

use onionskin::options::{DepthPeelingOptions, DualDepthPeelingOptions};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Frame, Image, Method, Renderer, Result, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> Result<()> {
    let scene = Scene::load_at(example::scene("molecule.toml"), Some([256, 192]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 256, 192)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    // This compiles the shaders, so that the first row has the time of a peel.
    let all = renderer.render(&scene, &single(0, 0.0))?.stats.iterations;
    renderer.render(&scene, &dual(0, 0.0))?;

    println!("         depth-peeling                          dual-depth-peeling");
    println!("peels     rms error  fragments left      ms      rms error  fragments left      ms");
    let mut pictures = [Vec::new(), Vec::new()];
    // At first every number of peels is tried, then fewer and fewer.
    let some =
        (1..all).filter(|peels| *peels <= 4 || (*peels <= 12 && peels % 2 == 0) || peels % 4 == 0);
    for peels in some.chain([all]) {
        let mut row = format!("{peels:5}");
        for (number, method) in [single(peels, 0.0), dual(peels, 0.0)].iter().enumerate() {
            let frame = renderer.render(&scene, method)?;
            row += &cells(&frame, &exact)?;
            if [1, 4, 12].contains(&peels) {
                pictures[number].push(frame.image);
            }
        }
        println!("{row}");
    }

    println!("\nratio    peels  rms error  fragments left      ms   stopped");
    for ratio in [0.0, 0.001, 0.01, 0.05, 0.2] {
        let frame = renderer.render(&scene, &single(0, ratio))?;
        let stats = &frame.stats;
        let row = cells(&frame, &exact)?;
        println!(
            "{ratio:<6} {:7}{row}   {}",
            stats.iterations,
            stats.stopped_text()
        );
    }

    let path = example::output("16_peels_and_ratio.png")?;
    let mut sheet = Panels::new("The molecule after a number of peels").columns(3);
    for (name, pictures) in ["depth peeling", "dual peeling"].iter().zip(&pictures) {
        for (peels, picture) in [1, 4, 12].iter().zip(pictures) {
            sheet = sheet.picture(picture, &format!("{name}, peels: {peels}"));
        }
    }
    sheet.save(&path)?;
    println!("{}", path.display());
    Ok(())
}

fn cells(frame: &Frame, exact: &Image) -> Result<String> {
    let rms = Comparison::new(&frame.image, exact, 0.0)?.rms;
    let left = frame.stats.lost.unwrap_or_default();
    Ok(format!("{rms:14.6} {left:15} {:7.1}", frame.stats.ms))
}

fn single(maximum_number_of_peels: u32, occlusion_ratio: f64) -> Method {
    Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels,
        occlusion_ratio,
        ..Default::default()
    })
}

fn dual(maximum_number_of_peels: u32, occlusion_ratio: f64) -> Method {
    Method::DualDepthPeeling(DualDepthPeelingOptions {
        maximum_number_of_peels,
        occlusion_ratio,
        ..Default::default()
    })
}
