//! Figure 6: ppAO and ppDP on four scenes, in counts, and in times in the whole edition.

use super::figure_5::{LOCAL, costs};
use super::table_1::{SCENES, SIZE};
use crate::error::Result;
use crate::low_level::edition::figures::plots::{svg_of, times_taken_on};
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::{BarGroup, bars};
use crate::methods::{ABufferCounts, ABufferOptions, Fill, Manager, Method};

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-6",
    source: "Lindholm et al. 2015, figure 6",
    title: "What ppAO and ppDP save, scene by scene",
    make,
};

/// The images in which elements and records are counted.
const COUNTED: [u32; 2] = [48, 36];
const FRAMES: usize = 3;
/// The scenes of the quick edition.
const FEW: [&str; 2] = ["protein", "medical"];
/// "Early-ray termination was enabled for transparency values less than 0.02 during all benchmarks" (section 7.2).
const TERMINATION: f32 = 0.02;
const MANAGERS: [Manager; 3] = [Manager::Ffb, Manager::Dfb, Manager::Ppll];

fn make(studio: &Studio) -> Result<Drawn> {
    let (mut rows, mut reserved, mut read) = (Vec::new(), Vec::new(), Vec::new());
    for (file, name, array) in SCENES {
        if studio.quick && !FEW.contains(&name) {
            continue;
        }
        let mut scene = studio.scene(file, SIZE)?;
        scene.size = COUNTED;
        let counted = costs(&mut studio.renderer(&scene)?, &scene, array, TERMINATION)?;
        let relative = |of: fn(&ABufferCounts) -> u64| {
            let first = of(&counted[0].1).max(1) as f64;
            let heights = counted.iter().map(|(_, counts)| of(counts) as f64 / first);
            BarGroup {
                name: name.into(),
                heights: heights.collect(),
            }
        };
        reserved.push(relative(|counts| counts.slots_reserved));
        read.push(relative(|counts| counts.records_read));
        rows.extend(counted.iter().map(|(way, counts)| {
            vec![
                format!("{name}, {way}"),
                counts.slots_reserved.to_string(),
                counts.slots_used.to_string(),
                counts.records_read.to_string(),
            ]
        }));
    }
    let names = LOCAL.map(|(name, ..)| name.to_owned());
    let mut drawn = Drawn::new(
        "Under the paper's conditions: rays end at a transparency of 0.02, and static arrays have 64, 32, 128 and 128 elements. \
         The paper's bars are measured on its GPUs, and cannot be had without them. Here the first bars are array elements that \
         are reserved, the second are records that are read, each relative to static arrays. What the fast memory is spared, ppDP \
         pays in reading.",
    )
    .drawing(
        svg_of(bars("Array elements reserved", "static array = 1", &names, &reserved)?),
        "bars of array elements: ppAO and ppDP reserve far less than static arrays in every scene",
    )
    .drawing(
        svg_of(bars("Records read", "static array = 1", &names, &read)?),
        "bars of records read: ppAO reads as many as static arrays, ppDP more",
    );
    if !studio.quick {
        let caption = times_taken_on("Time of a frame", studio);
        let (names, groups) = times(studio)?;
        drawn = drawn.drawing(
            svg_of(bars(
                &caption,
                "static array of the manager = 1",
                &names,
                &groups,
            )?),
            "twelve bars of times for each scene",
        );
    }
    Ok(drawn.table(
        &format!("Counts, {} x {} pixels", COUNTED[0], COUNTED[1]),
        &["", "elements reserved", "elements used", "records read"],
        rows,
    ))
}

/// Each manager with each way, relative to its static array. As in the paper, linked lists take their nodes by atomics.
fn times(studio: &Studio) -> Result<(Vec<String>, Vec<BarGroup>)> {
    let mut groups = Vec::new();
    let mut names = Vec::new();
    for (file, name, _) in SCENES {
        let scene = studio.scene(file, SIZE)?;
        let mut renderer = studio.renderer(&scene)?;
        let mut heights = Vec::new();
        names.clear();
        for manager in MANAGERS {
            let mut of_static = None;
            for (_, pp_ao, pp_dp) in LOCAL {
                let fill = match manager {
                    Manager::Ppll => Fill::Atomics,
                    _ => Fill::Automatic,
                };
                let method = Method::ABuffer(ABufferOptions {
                    manager,
                    pp_ao,
                    pp_dp,
                    fill,
                    ..ABufferOptions::default()
                });
                let ms = renderer.measure(&scene, &method, FRAMES)?.stats.ms;
                heights.push(ms / *of_static.get_or_insert(ms));
                names.push(method.to_string());
            }
        }
        groups.push(BarGroup {
            name: name.into(),
            heights,
        });
    }
    Ok((names, groups))
}
