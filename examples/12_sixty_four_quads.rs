//! What do ppAO and ppDP save (Lindholm et al. 2015, figures 5 and 7)?
//!
//! There are two scenes. In figure 7's 64 quads, every pixel is as deep as the array, so that ppAO can save nothing. In
//! the molecule, few pixels are deep. Prints the reserved and the used elements of Local Arrays, whose difference is
//! figure 5's grey, and the number of records that are read from the lists.
//!
//! Writes the picture of the 64 quads.
//!
//! `cargo run --example 12_sixty_four_quads [FOLDER]`

use onionskin::options::{ABufferOptions, Manager};
use onionskin::{Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [320, 240];

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    for file in ["sheets64.toml", "molecule.toml"] {
        let scene = Scene::load_at(example::scene(file), Some(SIZE))?;
        println!("{file}\n             slots reserved      used  records read  subpasses");
        for (name, pp_ao, pp_dp) in [
            ("static", false, false),
            ("ppAO", true, false),
            ("ppDP", false, true),
            ("ppAO + ppDP", true, true),
        ] {
            let options = ABufferOptions {
                manager: Manager::Dfb,
                pp_ao,
                pp_dp,
                ..ABufferOptions::default()
            };
            let frame = renderer.render(&scene, &Method::ABuffer(options))?;
            if let Some(counts) = frame.stats.a_buffer {
                println!(
                    "{name:<12} {:>14} {:>9} {:>13} {:>10}",
                    counts.slots_reserved, counts.slots_used, counts.records_read, counts.subpasses
                );
            }
            if file == "sheets64.toml" && !pp_ao && !pp_dp {
                frame
                    .image
                    .save(example::output("12_sixty_four_quads.png")?)?;
            }
        }
    }
    println!("{}", example::output("12_sixty_four_quads.png")?.display());
    Ok(())
}
