//! A pixel's fragments in the order of their depths, as a drawing.

use std::fmt::Write;

use crate::inspect::FragmentHistory;

/// Pixels from one depth to the next, and from one fragment to another of the same depth.
const ACROSS: usize = 44;
const DOWN: usize = 34;
/// The height of the axis under the fragments of different depths.
const TOP: usize = 24;

/// An SVG drawing of the fragments. Each is a group with its number (`data-fragment`). Fragments of the same depth stand above
/// one another. The place of each depth (`data-depth`) is its rank, so that close depths can be told apart.
pub(super) fn svg(fragments: &[FragmentHistory]) -> String {
    let mut depths: Vec<f32> = fragments.iter().map(|it| it.stored_depth).collect();
    depths.sort_by(f32::total_cmp);
    depths.dedup();
    let mut stacked = vec![0; depths.len()];
    let mut drawn = String::new();
    for (number, it) in fragments.iter().enumerate() {
        let rank = depths.partition_point(|depth| *depth < it.stored_depth);
        let (x, y) = (rank * ACROSS + 14, TOP + stacked[rank] * DOWN);
        stacked[rank] += 1;
        let [r, g, b, a] = it
            .color
            .to_array()
            .map(|channel| channel.clamp(0.0, 1.0) * 255.0);
        let solid = if it.opaque { " opaque" } else { "" };
        // Writing to a string cannot fail.
        let _ = write!(
            drawn,
            "<g class=\"fragment{solid}\" data-fragment=\"{number}\"><title>s{number}, depth {depth}, alpha \
             {alpha:.3}</title><rect x=\"{x}\" y=\"{y}\" width=\"22\" height=\"26\" rx=\"3\" fill=\"rgb({r:.0},{g:.0},{b:.0})\" \
             /><text x=\"{middle}\" y=\"{label}\">s{number}</text></g>",
            depth = it.stored_depth,
            alpha = a / 255.0,
            middle = x + 11,
            label = y + 17,
        );
    }
    let rows = stacked.iter().copied().max().unwrap_or(0);
    let (width, height) = (depths.len() * ACROSS + 28, TOP + rows * DOWN + 10);
    let places = depths
        .iter()
        .enumerate()
        .map(|(rank, depth)| format!("\"{depth}\":{}", rank * ACROSS + 25))
        .collect::<Vec<_>>()
        .join(",");
    format!(
        "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" data-end=\"{width}\" \
         data-places='{{{places}}}'><line class=\"stored\" x1=\"0\" x2=\"0\" y1=\"2\" y2=\"{height}\" />{drawn}</svg>"
    )
}
