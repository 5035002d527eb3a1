//! Figure 3: how iterations and time grow with the number of slices.

use super::slices_and_cone::with_slices;
use crate::error::Result;
use crate::low_level::edition::figures::plots::times_taken_on;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::{Method, Renderer, Stats, Variant};
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "carr-3",
    source: "Carr et al. 2008, figure 3",
    title: "A cone through more and more slices",
    make,
};

/// Small, because layer peeling draws each of 384 slices some 800 times.
pub const SIZE: [u32; 2] = [32, 24];
const SLICES: [u32; 6] = [16, 32, 64, 128, 256, 384];
/// Those of the quick edition, which has no times.
const FEW: usize = 4;
/// A longer frame's time is taken once. Its counts are the same in every frame, and its time differs little.
const LONG: u32 = 128;
const NAMES: [&str; 4] = [
    "layer peeling",
    "hybrid layer peeling",
    "coherent layer peeling A",
    "coherent layer peeling B",
];

/// The four methods of the figure.
pub fn methods() -> [Method; 4] {
    [
        Method::LayerPeeling(Default::default()),
        Method::HybridLayerPeeling(Default::default()),
        Method::CoherentLayerPeeling(Variant::A.into()),
        Method::CoherentLayerPeeling(Variant::B.into()),
    ]
}

/// For each number of slices, what each of the [`methods`] counts, with the median time of a few frames if `timed`. `slices` is
/// the bundled scene, of [`SIZE`].
///
/// # Errors
/// If the driver fails.
pub fn rows(
    renderer: &mut Renderer<'_>,
    slices: &Scene,
    counts: &[u32],
    timed: bool,
) -> Result<Vec<[Stats; 4]>> {
    let mut rows = Vec::new();
    for &count in counts {
        let scene = with_slices(slices.clone(), count, 2)?;
        let frames = if count > LONG { 1 } else { 3 };
        let stats = methods().map(|method| match timed {
            true => Ok(renderer.measure(&scene, &method, frames)?.stats),
            false => Ok(renderer.render(&scene, &method)?.stats),
        });
        let [layers, hybrid, a, b] = stats;
        rows.push([layers?, hybrid?, a?, b?]);
    }
    Ok(rows)
}

/// The numbers of slices up to 384, or the first of them.
pub fn counts(quick: bool) -> &'static [u32] {
    match quick {
        true => &SLICES[..FEW],
        false => &SLICES,
    }
}

fn make(studio: &Studio) -> Result<Drawn> {
    let mut slices = studio.scene("slices", SIZE)?;
    slices.size = SIZE;
    let mut renderer = studio.renderer(&slices)?;
    let counts = counts(studio.quick);
    let timed = !studio.quick;
    let rows = rows(&mut renderer, &slices, counts, timed)?;
    let line = |method: usize, value: fn(&Stats) -> f64| -> Vec<[f64; 2]> {
        let values = rows.iter().map(|row| value(&row[method]));
        counts
            .iter()
            .zip(values)
            .map(|(&count, value)| [f64::from(count), value])
            .collect()
    };
    let mut iterations = Chart::new("Iterations", "slices", "iterations").logarithmic();
    for (method, name) in NAMES.iter().enumerate() {
        iterations = iterations.line(name, line(method, |stats| f64::from(stats.iterations)));
    }
    let mut drawn = Drawn::new(
        "Layer peeling takes an iteration for each slice, so its line is straight. Hybrid layer peeling stays at 3. Coherent \
         layer peeling is constant, too, up to 192 slices. Then the 128 surfaces that an iteration can count at most begin to \
         show, which the paper's figure does not have (CX29).",
    )
    .chart(iterations);
    if timed {
        let mut ms = Chart::new(
            &times_taken_on("Time of a frame", studio),
            "slices",
            "time, hybrid layer peeling at 16 slices = 1",
        )
        .logarithmic();
        let first = rows[0][1].ms;
        for (method, name) in NAMES.iter().enumerate() {
            let mut points = line(method, |stats| stats.ms);
            points.iter_mut().for_each(|point| point[1] /= first);
            ms = ms.line(name, points);
        }
        drawn = drawn.chart(ms);
    }
    let cell = |stats: &Stats| format!("{} it, {} g", stats.iterations, stats.geometry_passes);
    let table = counts.iter().zip(&rows).map(|(count, row)| {
        let cells = row.each_ref().map(cell);
        [vec![count.to_string()], cells.to_vec()].concat()
    });
    drawn = drawn.table(
        &format!(
            "Iterations (it) and geometry passes (g), {} x {} pixels",
            SIZE[0], SIZE[1]
        ),
        &["slices", NAMES[0], NAMES[1], NAMES[2], NAMES[3]],
        table.collect(),
    );
    if timed {
        let speed = counts.iter().zip(&rows).map(|(count, row)| {
            let ratio = |method: usize| format!("{:.1}", row[method].ms / row[1].ms);
            vec![count.to_string(), ratio(0), ratio(2), ratio(3)]
        });
        let caption = times_taken_on(
            "How many times as long as hybrid layer peeling (the paper at 256 slices: 52 or 62, and about 6)",
            studio,
        );
        drawn = drawn.table(
            &caption,
            &["slices", NAMES[0], NAMES[2], NAMES[3]],
            speed.collect(),
        );
    }
    Ok(drawn)
}
