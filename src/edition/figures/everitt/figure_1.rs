//! Figure 1: why order matters.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::Method;

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-1",
    source: "Everitt 2001, figure 1",
    title: "Three knots through each other, right and wrong",
    make,
};

/// The largest difference that nobody sees: one step of an 8-bit channel.
const STEP: f64 = 1.0 / 255.0;

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [480, 360])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let peeled = renderer.render(&scene, &Method::DepthPeeling(Default::default()))?;
    let blended = renderer.render(&scene, &Method::Blend)?;
    let mut rows = Vec::new();
    for frame in [&peeled, &blended] {
        let error = Comparison::new(&frame.image, &exact, STEP)?;
        rows.push(vec![
            frame.stats.method.clone(),
            format!("{:.6}", error.max),
            error.over.to_string(),
        ]);
    }
    let pixels = exact.pixels.len();
    Drawn::new(
        "Each knot lies partly before and partly behind the others. So no order of whole knots is right. Depth peeling \
         sorts at every pixel, and is right.",
    )
    .flipped(
        "peeled",
        &peeled.image,
        "depth peeling",
        "three translucent knots; where they cross, the nearer one tints the farther one",
    )
    .flipped(
        "blended",
        &blended.image,
        "blended in the order of submission",
        "the same knots; the one that was drawn last tints the others everywhere",
    )
    .difference(
        "difference",
        [&peeled.image, &blended.image],
        2.0,
        "the difference of the two, times 2",
    )
    .map(|drawn| {
        drawn.table(
            "Against the exact image",
            &["method", "largest error", &format!("pixels of {pixels} off by more than 1/255")],
            rows,
        )
    })
}
