//! Figure 3: the layers of a teapot.

use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::options::{Compositing, DepthPeelingOptions};
use crate::methods::{Layer, Method};
use crate::report::opaque;
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-3",
    source: "Everitt 2001, figure 3",
    title: "The layers one by one",
    make,
};

/// What each picture shows, for those who do not see it.
const ALTS: [&str; 4] = [
    "a teapot, red outside, over a blue plane",
    "the inside of the pot, green, and the plane where the pot covers it",
    "mostly blue plane, in the shape of the pot",
    "small pieces of green and blue, where handle and spout stood before the body",
];

fn make(studio: &Studio) -> Result<Drawn> {
    let mut drawn = Drawn::new(
        "Outside red, inside green, the plane blue; the layers are drawn opaque, so that they can be seen. Layer 0 is the \
         nearest surface at each pixel. Each layer has fewer samples than the one before. Layer 2 is mostly plane, in the \
         shape of the teapot.",
    );
    let shown = layers(studio, &studio.scene("teapot", [480, 360])?)?;
    for (number, (layer, alt)) in shown.iter().zip(ALTS).enumerate() {
        let label = format!("layer {number}");
        drawn = drawn.picture(&format!("layer-{number}"), &opaque(layer), &label, alt);
    }
    let counted = layers(studio, &studio.scene_of_size("teapot", [160, 120])?)?;
    let samples = |layer: &Layer| layer.depth.iter().filter(|&&it| it < 1.0).count();
    let rows = counted.iter().map(samples).enumerate();
    let rows = rows.map(|(number, samples)| vec![number.to_string(), samples.to_string()]);
    Ok(drawn.table(
        "Samples at 160 x 120 pixels (the paper gives no numbers)",
        &["layer", "samples"],
        rows.take(ALTS.len()).collect(),
    ))
}

fn layers(studio: &Studio, scene: &Scene) -> Result<Vec<Layer>> {
    let options = DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..Default::default()
    };
    let method = Method::DepthPeeling(options);
    Ok(studio.renderer(scene)?.render(scene, &method)?.layers)
}
