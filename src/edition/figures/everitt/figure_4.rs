//! Figure 4: a cross section of the view volume.

use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio, deepest_column};
use crate::report::{CrossSection, Plot};

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-4",
    source: "Everitt 2001, figure 4",
    title: "Each pass strips a layer away",
    make,
};

/// The layers that the paper shows.
const LAYERS: usize = 3;

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [560, 420])?;
    let column = deepest_column(studio.context, &scene)?;
    let title = "A vertical cut through three knots, seen from the left";
    let [plot, _] = CrossSection::new(title, LAYERS, &column).draw()?;
    let drawn = Drawn::new(
        "The cut goes through the column of pixels that has most fragments. Bold is the layer, thin is what it hides, grey is \
         what was peeled away. The depths of a layer vary, and its pieces are no whole polygons.",
    );
    let samples = |layer: usize| column.iter().filter(|pixel| pixel.len() > layer).count();
    let rows = (0..LAYERS).map(|layer| vec![layer.to_string(), samples(layer).to_string()]);
    let drawn = drawn.table(
        "Samples in this column of pixels",
        &["layer", "samples"],
        rows.collect(),
    );
    Ok(match plot {
        Plot::Svg(svg) => drawn.drawing(
            svg,
            "three frames of one cut, in each of which another layer is bold: first the nearest outlines, then those behind",
        ),
        Plot::Png(picture) => drawn.picture("cut", &picture, title, title),
    })
}
