//! What do ppAO and ppDP save (Lindholm et al. 2015, figures 5 and 7)?
//!
//! There are two scenes. In figure 7's 64 quads, every pixel is as deep as the array, so that ppAO can save nothing. In
//! the molecule, few pixels are deep. Prints the reserved and the used elements of Local Arrays, whose difference is
//! figure 5's grey, and the number of records that are read from the lists.
//!
//! Draws figure 5 from two pixels of the molecule, the deepest and one that is deeper than a quarter, by runs on the emulated pixel.
//!
//! `cargo run --example 12_sixty_four_quads [FOLDER]`

use std::collections::BTreeMap;

use onionskin::low_level::emulator::run_on_lists;
use onionskin::low_level::papers::lindholm_2015::components::{
    PP_AO, PP_AO_AMENDMENT, PP_DP, PP_DP_AMENDMENTS, STATIC_ARRAY,
};
use onionskin::options::{ABufferOptions, Manager};
use onionskin::report::local_arrays;
use onionskin::{Context, Fragment, Method, Renderer, Scene};

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
        }
    }
    figure_5(&context)
}

fn figure_5(context: &Context) -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("molecule.toml"), Some(SIZE))?;
    let mut pixels = BTreeMap::<_, Vec<Fragment>>::new();
    for fragment in example::fragments(context, &scene)? {
        let list = pixels.entry((fragment.y, fragment.x)).or_default();
        list.push(Fragment {
            depth: fragment.depth,
            color: fragment.color,
            order: list.len() as u32,
        });
    }
    let mut lists: Vec<_> = pixels.into_values().collect();
    lists.sort_by_key(Vec::len);
    let two = [
        lists[lists.len() - 1].clone(),
        lists[lists.len() / 4].clone(),
    ];
    let run = |algorithm, amendments: &[_], array| {
        run_on_lists(algorithm, amendments, &two, array, 64).map(|run| run.pixels)
    };
    let fixed = run(&STATIC_ARRAY, &[], 64)?;
    let pp_ao = run(&PP_AO, &[PP_AO_AMENDMENT], 64)?;
    let pp_dp = run(&PP_DP, &PP_DP_AMENDMENTS, 8)?;
    let runs = [("static", &fixed), ("ppAO", &pp_ao), ("ppDP", &pp_dp)];
    let figure = local_arrays(
        "Local Arrays (Lindholm et al. 2015, figure 5): two pixels of the molecule",
        [0, 1].map(|n| two[n].len() as u32),
        &runs.map(|(name, pixels)| (name, [&pixels[0], &pixels[1]])),
    );
    for ending in ["svg", "png"] {
        let path = example::output(&format!("12_sixty_four_quads.{ending}"))?;
        figure.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
