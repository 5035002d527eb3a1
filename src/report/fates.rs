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

#[cfg(test)]
mod tests {
    use roxmltree::Document;

    use super::*;
    use crate::low_level::emulator::Fate;
    use crate::report::Plot;
    use crate::steps::Objects;

    #[test]
    fn each_fragment_has_the_colour_and_the_letter_of_its_fate() {
        let fate = |order, outcome| Fate {
            order,
            depth: 0.5,
            outcome,
            stencil: [0, 1],
            stored_depth: [1.0, 0.5],
            colors: Vec::new(),
            images: Vec::new(),
            list: None,
        };
        let outcomes = [
            FragmentOutcome::Pass,
            FragmentOutcome::Pass,
            FragmentOutcome::StencilFail,
            FragmentOutcome::DepthFail,
            FragmentOutcome::Discarded,
        ];
        let draw = Draw {
            program: "a program",
            objects: Objects::Transparent,
            target: None,
            colors: Vec::new(),
            depth: None,
            fates: (0..).zip(outcomes).map(|(n, it)| fate(n, it)).collect(),
            left: (251, 0.7536),
        };
        let title = "a pass & its <title>";
        let [Plot::Svg(svg), Plot::Png(_)] = fates(title, &[("first", &draw)]).draw().unwrap()
        else {
            panic!("an SVG and a picture were promised")
        };
        let document = Document::parse(&svg).unwrap();
        let filled = |color: &str| {
            let of_color = document
                .descendants()
                .filter(|n| n.attribute("fill") == Some(color));
            of_color.filter(|n| n.has_tag_name("rect")).count()
        };
        // Each has one more in the key.
        let counts = ["#009E73", "#D55E00", "#F0E442", "#DDDDDD"].map(filled);
        assert_eq!(counts, [2 + 1, 1 + 1, 1 + 1, 1 + 1], "{svg}");
        let texts = document.descendants().filter(|n| n.has_tag_name("text"));
        let texts: Vec<_> = texts.filter_map(|n| n.text()).map(str::trim).collect();
        let expected = ["s0", "s4", "stencil", "depth", "first", "251", "0.7536"];
        for text in expected.into_iter().chain([title]) {
            assert!(texts.contains(&text), "no {text}: {texts:?}");
        }
        let letters: String = texts
            .iter()
            .filter(|text| text.len() == 1)
            .copied()
            .collect();
        assert_eq!(letters, "PPSDC");
    }
}
