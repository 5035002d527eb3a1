//! Figure 2 of Carr et al. (2008), pass by pass: eleven surfaces at one pixel, submitted as s0 to s10. Everything up to
//! s4 has been peeled.
//!
//! The emulated pixel says what happens to each surface. OpenGL runs the same steps beside it: `figure_2::PASSES`, which are
//! listings as data. The stencil value and the depth that both leave are printed under each table. One sentence of the paper's
//! trace is wrong: see pass 3.
//!
//! Writes one picture, as PNG and as SVG, with a row per pass and a column per surface.
//!
//! `cargo run --example 05_figure_2_pass_by_pass [FOLDER]`

use onionskin::low_level::edition::figures::carr::figure_2::run_passes;
use onionskin::low_level::emulator::Draw;
use onionskin::report::fates;
use onionskin::{Context, Result};

#[path = "common/example.rs"]
mod example;

fn main() -> Result<()> {
    let context = Context::headless()?;
    let passes = run_passes(&context)?;
    for pass in &passes {
        println!("{}", pass.title);
        print!("{}", pass.draw);
        let (stencil, depth) = pass.on_gl;
        println!("  OpenGL has: stencil {stencil}, depth {depth}\n");
    }

    let path = example::output("05_figure_2_pass_by_pass.png")?;
    let draws: Vec<(&str, &Draw)> = passes.iter().map(|it| (it.title, &it.draw)).collect();
    let title = "Figure 2 of Carr et al. 2008: eleven surfaces at one pixel, pass by pass";
    let figure = fates(title, &draws);
    figure.save(&path)?;
    figure.save(path.with_extension("svg"))?;
    println!("{}", path.display());
    Ok(())
}
