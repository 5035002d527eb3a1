//! What each draw does to each fragment of a pixel, as rows of boxes.

use super::key::Key;
use super::palette::of_outcome;
use super::strips::{Cell, Strip, Strips};
use crate::low_level::emulator::{Draw, FragmentOutcome};

/// A row for each draw and a box for each fragment, in the order of submission. The rows have titles, and end with the
/// pixel's stencil value and depth after the draw.
pub fn fates(title: &str, draws: &[(&str, &Draw)]) -> Strips {
    let first = draws.first().map_or(&[][..], |(_, draw)| &draw.fates);
    let heads = first.iter().map(|fate| format!("s{}", fate.order));
    let row = |&(title, draw): &(&str, &Draw)| {
        let cell = |outcome| Cell::new(of_outcome(outcome), letter(outcome));
        let (stencil, depth) = draw.left;
        Strip {
            label: title.into(),
            cells: draw.fates.iter().map(|fate| cell(fate.outcome)).collect(),
            after: vec![stencil.to_string(), format!("{depth:.4}")],
        }
    };
    let mut key = Key::default();
    for (outcome, means) in [
        (FragmentOutcome::Pass, "P passes all tests"),
        (FragmentOutcome::StencilFail, "S fails the stencil test"),
        (FragmentOutcome::DepthFail, "D fails the depth test"),
        (FragmentOutcome::Discarded, "C is clipped"),
    ] {
        key.push(of_outcome(outcome), means);
    }
    Strips {
        title: title.into(),
        heads: [heads.collect(), vec!["stencil".into(), "depth".into()]],
        rows: draws.iter().map(row).collect(),
        cell: 44,
        key,
    }
}

/// Colour is not to be the only sign.
fn letter(outcome: FragmentOutcome) -> char {
    match outcome {
        FragmentOutcome::Pass => 'P',
        FragmentOutcome::StencilFail => 'S',
        FragmentOutcome::DepthFail => 'D',
        FragmentOutcome::Discarded => 'C',
    }
}
