//! The blend factors of section 6, as the sentence beside them says and as they are printed.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::{CoherentOptions, Frame, Method, TriangleSort, Variant};
use crate::steps::Reading;

pub(super) const FIGURE: Figure = Figure {
    key: "carr-section-6",
    source: "Carr et al. 2008, section 6",
    title: "Variant B by the sentence, and by the factors that are printed beside it",
    make,
};

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [336, 252])?;
    let mut renderer = studio.renderer(&scene)?;
    let mut render = |reading| {
        let options = CoherentOptions {
            sorting: TriangleSort::Submission,
            reading,
            ..Variant::B.into()
        };
        renderer.render(&scene, &Method::CoherentLayerPeeling(options))
    };
    let (amended, printed) = (render(Reading::Amended)?, render(Reading::AsPrinted)?);
    let error = Comparison::new(&amended.image, &printed.image, 1.0 / 255.0)?;
    let row = |name: &str, frame: &Frame| {
        let stats = &frame.stats;
        vec![
            name.into(),
            stats.iterations.to_string(),
            format!(
                "{} of {}",
                stats.fragments - stats.lost.unwrap_or(0),
                stats.fragments
            ),
            stats.stopped_text(),
        ]
    };
    let drawn = Drawn::new(format!(
        "By the printed factors z_min_prev becomes the product of all earlier depths, which is too small. So runs are cut, and \
         the loop ends too early. {} pixels differ by more than 1/255 (CX16).",
        error.over
    ))
    .flipped(
        "sentence",
        &amended.image,
        "as the sentence says: DST_ALPHA, ZERO",
        "three translucent knots, complete",
    )
    .flipped(
        "printed",
        &printed.image,
        "as printed: ZERO, DEST_ALPHA",
        "the same knots, with layers missing where three or more overlap",
    )
    .difference(
        "difference",
        [&amended.image, &printed.image],
        1.0,
        "the difference of the two",
    )?;
    Ok(drawn.table(
        "What is in the image, and why the loop ended",
        &[
            "factors",
            "iterations",
            "fragments in the image",
            "ended because of",
        ],
        vec![
            row("as the sentence says", &amended),
            row("as printed", &printed),
        ],
    ))
}
