//! What do ppAO and ppDP save (Lindholm et al. 2015, figures 5 and 7)?
//!
//! There are two scenes. In figure 7's 64 quads, every pixel is as deep as the array, so that ppAO can save nothing. In
//! the molecule, few pixels are deep. Prints the reserved and the used elements of Local Arrays, whose difference is
//! figure 5's grey, and the number of records that are read from the lists.
//!
//! Draws figure 5 from two pixels of the molecule, the deepest and one that is deeper than a quarter, by runs on the emulated pixel.
//!
//! `cargo run --example 12_sixty_four_quads [FOLDER]`

use onionskin::low_level::edition::figures::lindholm::figure_5::{costs, two_pixels};
use onionskin::report::local_arrays;
use onionskin::{Context, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [320, 240];

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    for file in ["sheets64.toml", "molecule.toml"] {
        let scene = Scene::load_at(example::scene(file), Some(SIZE))?;
        println!("{file}\n             slots reserved      used  records read  subpasses");
        for (name, counts) in costs(&mut renderer, &scene, 64, 0.0)? {
            println!(
                "{name:<12} {:>14} {:>9} {:>13} {:>10}",
                counts.slots_reserved, counts.slots_used, counts.records_read, counts.subpasses
            );
        }
    }

    let scene = Scene::load_at(example::scene("molecule.toml"), Some(SIZE))?;
    let title = "Local Arrays (Lindholm et al. 2015, figure 5): two pixels of the molecule";
    let two = two_pixels(&context, &scene)?;
    let runs = two
        .runs
        .each_ref()
        .map(|(name, pixels)| (*name, pixels.each_ref()));
    let figure = local_arrays(title, two.lists, &runs);
    for ending in ["svg", "png"] {
        let path = example::output(&format!("12_sixty_four_quads.{ending}"))?;
        figure.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
