//! Section 1: what the painter's algorithm makes of surfaces that have no order, and how the verified painter finds out.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Drawn, Figure, Studio, printed};
use crate::methods::{Method, Painter, VerifiedPainter};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-painter",
    source: "Carr et al. 2008, section 1",
    title: "The painter's algorithm, and one that proves its order",
    make,
};

/// The largest difference that nobody sees: one step of an 8-bit channel.
const STEP: f64 = 1.0 / 255.0;

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [336, 252])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let painter = renderer.render(&scene, &Painter)?;
    let verified = renderer.render(&scene, &VerifiedPainter)?;
    let mut rows = Vec::new();
    for frame in [&painter, &verified] {
        let error = Comparison::new(&frame.image, &exact, STEP)?;
        let marked = frame.stats.verified.map(|counts| counts.marked_pixels);
        rows.push(vec![
            frame.stats.method.clone(),
            error.over.to_string(),
            printed::error(error.max),
            marked.map_or_else(|| "it cannot tell".into(), |pixels| pixels.to_string()),
        ]);
    }
    let pixels = exact.pixels.len();
    let drawn = Drawn::new(
        "Triangles are sorted by their middles. Where two large ones of different knots overlap, the nearer middle need not be \
         the nearer triangle. The differences are small and easily missed, which is what is bad about them. The verified \
         painter marks the pixels where its own order failed, and takes lists for them.",
    )
    .flipped(
        "painter",
        &painter.image,
        "painter's algorithm",
        "three translucent knots",
    )
    .flipped(
        "verified",
        &verified.image,
        "verified painter",
        "the same three knots; some edges differ",
    )
    .difference(
        "difference",
        [&painter.image, &verified.image],
        4.0,
        "the difference of the two, times 4",
    )?;
    Ok(drawn.table(
        "Against the exact image",
        &[
            "method",
            &format!("pixels of {pixels} off by more than 1/255"),
            "largest error",
            "pixels whose order was not proved",
        ],
        rows,
    ))
}
