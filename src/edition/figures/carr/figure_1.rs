//! Figure 1: a beam through the slices of a volume, by layer peeling and by hybrid layer peeling.

use super::slices_and_cone::with_slices;
use crate::error::Result;
use crate::low_level::edition::figures::printed::printed;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::{DepthPeelingOptions, Method, Stats};
use crate::papers::carr_2008::PAPER;

pub(super) const FIGURE: Figure = Figure {
    key: "carr-1",
    source: "Carr et al. 2008, figure 1",
    title: "A beam through 256 slices of a volume",
    make,
};

const SLICES: u32 = 256;
/// Layer peeling draws every slice some 500 times, so it is counted on few pixels. Both methods have the same counts here as on
/// many.
const COUNTED: [u32; 2] = [32, 24];
const LAYERS: Method = Method::LayerPeeling(crate::methods::LayerPeelingOptions {
    reading: crate::steps::Reading::Amended,
});
const HYBRID: Method = Method::HybridLayerPeeling(crate::methods::HybridLayerPeelingOptions {
    reading: crate::steps::Reading::Amended,
});

fn make(studio: &Studio) -> Result<Drawn> {
    let empty = studio.scene("slices", [336, 252])?;
    let scene = with_slices(empty.clone(), SLICES, studio.number(24, 8))?;
    let mut renderer = studio.renderer(&scene)?;
    let hybrid = renderer.render(&scene, &HYBRID)?;
    let three = Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels: hybrid.stats.iterations,
        ..DepthPeelingOptions::default()
    });
    let three = renderer.render(&scene, &three)?;

    let mut few = with_slices(empty, SLICES, 1)?;
    few.size = COUNTED;
    let mut renderer = studio.renderer(&few)?;
    let [layers, counted] = [LAYERS, HYBRID].map(|method| renderer.render(&few, &method));
    let (layers, counted) = (layers?.stats, counted?.stats);
    let drawn = Drawn::new(format!(
        "Both pictures are what {} iterations make. Hybrid layer peeling is finished: it peels the beam, and blends the slices \
         that lie between. Depth peeling has the three nearest layers, and needs some 250 more. The speed-ups of 62 and 52 that \
         the paper names are of one scene (CX28); here, the triangles that are drawn are compared.",
        hybrid.stats.iterations
    ))
    .flipped(
        "hybrid",
        &hybrid.image,
        "hybrid layer peeling, 3 iterations",
        "a translucent green beam inside of a cloud of 256 slices",
    )
    .flipped(
        "layers",
        &three.image,
        "layer by layer, 3 iterations",
        "almost nothing: the three nearest layers of 256 are faint",
    );
    Ok(drawn.table(
        &format!(
            "{SLICES} slices and a cone, {} x {} pixels",
            COUNTED[0], COUNTED[1]
        ),
        &[
            "",
            "the paper's iterations",
            "iterations",
            "geometry passes",
            "triangles drawn",
        ],
        vec![
            row("layer peeling", printed(&PAPER, "C03", 1), &layers),
            row("hybrid layer peeling", printed(&PAPER, "C03", 0), &counted),
            vec![
                "the first for one of the second".into(),
                ratio(257.0, 3.0),
                ratio(layers.iterations.into(), counted.iterations.into()),
                ratio(
                    layers.geometry_passes as f64,
                    counted.geometry_passes as f64,
                ),
                ratio(layers.triangles as f64, counted.triangles as f64),
            ],
        ],
    ))
}

fn row(name: &str, paper: &str, stats: &Stats) -> Vec<String> {
    vec![
        name.into(),
        paper.into(),
        stats.iterations.to_string(),
        stats.geometry_passes.to_string(),
        stats.triangles.to_string(),
    ]
}

fn ratio(a: f64, b: f64) -> String {
    format!("{:.0}", a / b)
}
