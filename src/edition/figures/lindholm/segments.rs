//! Section 5: the segment of each pixel, and its subpasses.

use super::left;
use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::Measure;
use crate::methods::ABufferOptions;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-segments",
    source: "Lindholm et al. 2015, sections 5.1 and 5.2",
    title: "ppAO's segments and ppDP's subpasses, pixel by pixel",
    make,
};

/// The places of subpasses and of reserved elements among the costs.
const SUBPASSES: usize = 2;
const RESERVED: usize = 3;

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("molecule", [384, 288])?;
    let mut renderer = studio.renderer(&scene)?;
    let with = |pp_ao, pp_dp| ABufferOptions {
        pp_ao,
        pp_dp,
        ..ABufferOptions::default()
    };
    let (_, by_segments) = left::render(&mut renderer, &scene, with(true, false))?;
    let (_, by_peeling) = left::render(&mut renderer, &scene, with(false, true))?;
    let segments = by_segments.cost(RESERVED);
    let subpasses = by_peeling.cost(SUBPASSES);
    let size = scene.size;
    // Each segment is twice as large as the one before, and as far from it in colour.
    let steps: Vec<f64> = segments
        .iter()
        .map(|&it| f64::from(it / 4).max(1.0).log2())
        .collect();
    let drawn = Drawn::new(
        "Read back from OpenGL. Pixels of a segment need not lie side by side, and most are in the smallest one. Flip to the \
         subpasses of ppDP, and the same pixels stand out: those of many layers.",
    )
    .flipped(
        "layers",
        &left::counts(size, &by_segments.counters),
        "layers",
        "a molecule as counts of layers",
    )
    .flipped(
        "segments",
        &Measure::new(size[0], size[1], steps).image(),
        "ppAO: the array of each pixel, from 8 (blue) to the largest (yellow)",
        "the same molecule in a few even colours, one for each array size",
    )
    .flipped(
        "subpasses",
        &left::counts(size, &subpasses),
        "ppDP: how often each list is read",
        "the same molecule as counts of subpasses",
    );
    let count = |of: &[u32], value: u32| of.iter().filter(|&&it| it == value).count().to_string();
    let by_size = ABufferOptions::DEFAULT
        .segments()
        .map(|size| vec![size.to_string(), count(&segments, size)]);
    let most = subpasses.iter().max().copied().unwrap_or(0);
    let by_number = (1..=most).map(|number| vec![number.to_string(), count(&subpasses, number)]);
    Ok(drawn
        .table(
            "Pixels in each of ppAO's segments",
            &["array", "pixels"],
            by_size.collect(),
        )
        .table(
            "Pixels by ppDP's subpasses, arrays of 8",
            &["subpasses", "pixels"],
            by_number.collect(),
        ))
}
