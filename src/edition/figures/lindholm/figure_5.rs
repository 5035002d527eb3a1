//! Figure 5: the Local Arrays of static arrays, ppAO and ppDP, for a heavy and a light pixel.

use std::collections::BTreeMap;

use crate::emulator::{Resolved, run_on_lists};
use crate::error::Result;
use crate::fragment::Fragment;
use crate::gl::Context;
use crate::low_level::edition::figures::plots::svg_of;
use crate::low_level::edition::figures::{Drawn, Figure, Studio, fragments};
use crate::low_level::report::local_arrays;
use crate::methods::{ABufferCounts, ABufferOptions, ArraySort, Manager, Method, Renderer};
use crate::papers::lindholm_2015::components::{
    PP_AO, PP_AO_AMENDMENT, PP_DP, PP_DP_AMENDMENTS, STATIC_ARRAY,
};
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-5",
    source: "Lindholm et al. 2015, figure 5",
    title: "Local Arrays of a heavy and a light pixel",
    make,
};

/// The four ways to manage Local Arrays: a name, whether ppAO, whether ppDP.
pub const LOCAL: [(&str, bool, bool); 4] = [
    ("static", false, false),
    ("ppAO", true, false),
    ("ppDP", false, true),
    ("ppAO + ppDP", true, true),
];

/// What the four ways cost on a scene, by dynamic fragment buffers.
///
/// # Errors
/// If the driver fails.
pub fn costs(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    array: u32,
    termination: f32,
) -> Result<Vec<(&'static str, ABufferCounts)>> {
    let mut rows = Vec::new();
    for (name, pp_ao, pp_dp) in LOCAL {
        let options = ABufferOptions {
            manager: Manager::Dfb,
            pp_ao,
            pp_dp,
            array,
            termination,
            // The counts do not depend on the sort, and the program of this one is compiled soonest.
            sort: ArraySort::Insertion,
            ..ABufferOptions::default()
        };
        let frame = renderer.render(scene, &Method::ABuffer(options))?;
        rows.push((name, frame.stats.a_buffer.unwrap_or_default()));
    }
    Ok(rows)
}

/// Two pixels, and what the static array, ppAO and ppDP do with their lists.
#[derive(Clone, Debug)]
pub struct TwoPixels {
    /// The lengths of the lists.
    pub lists: [u32; 2],
    /// Each way with its two results.
    pub runs: [(&'static str, [Resolved; 2]); 3],
}

/// Two pixels of a scene, the deepest and one that is deeper than a quarter of the covered ones, as the emulated pixel resolves
/// them.
///
/// # Errors
/// If the driver fails.
pub fn two_pixels(context: &Context, scene: &Scene) -> Result<TwoPixels> {
    let mut pixels = BTreeMap::<_, Vec<Fragment>>::new();
    for fragment in fragments(context, scene)? {
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
    let run = |algorithm, amendments: &[_], array| -> Result<[Resolved; 2]> {
        let pixels = run_on_lists(algorithm, amendments, &two, array, 64)?.pixels;
        Ok([pixels[0].clone(), pixels[1].clone()])
    };
    Ok(TwoPixels {
        lists: [0, 1].map(|n| two[n].len() as u32),
        runs: [
            ("static", run(&STATIC_ARRAY, &[], 64)?),
            ("ppAO", run(&PP_AO, &[PP_AO_AMENDMENT], 64)?),
            ("ppDP", run(&PP_DP, &PP_DP_AMENDMENTS, 8)?),
        ],
    })
}

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("molecule", [288, 216])?;
    let two = two_pixels(studio.context, &scene)?;
    let runs = two
        .runs
        .each_ref()
        .map(|(name, pixels)| (*name, pixels.each_ref()));
    let figure = local_arrays("", two.lists, &runs);
    let rows = costs(&mut studio.renderer(&scene)?, &scene, 64, 0.0)?;
    let drawn = Drawn::new(
        "Two pixels of the molecule: the deepest, and a light one. A box is an element of the Local Array, and grey ones are \
         reserved for nothing. The static array is 64 for every pixel. ppAO takes the smallest of 8, 16, 32 and 64 that is large \
         enough. ppDP has 8 and uses them again and again.",
    )
    .drawing(
        svg_of(figure.draw()?),
        "rows of boxes for two pixels: the static arrays are mostly grey, ppAO's less, ppDP's hardly",
    );
    Ok(drawn.table(
        &format!(
            "All pixels of the molecule, {} x {}",
            scene.size[0], scene.size[1]
        ),
        &[
            "",
            "elements reserved",
            "elements used",
            "records read",
            "subpasses",
        ],
        rows.iter()
            .map(|(name, counts)| row(name, counts))
            .collect(),
    ))
}

pub(super) fn row(name: &str, counts: &ABufferCounts) -> Vec<String> {
    let numbers = [
        counts.slots_reserved,
        counts.slots_used,
        counts.records_read,
        counts.subpasses,
    ];
    let cells = numbers.iter().map(u64::to_string);
    std::iter::once(name.to_owned()).chain(cells).collect()
}
