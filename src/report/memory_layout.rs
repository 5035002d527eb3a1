//! Figure 4 of Lindholm et al. 2015: where FFB, DFB and PPLL put the fragments of a few pixels.

use super::key::Key;
use super::palette::{DISTINCT, UNUSED};
use super::strips::{Cell, Strip, Strips};

/// The layout of the pixels that these fragments belong to. Each fragment is given as its pixel, 0 to `pixels` - 1, in
/// the order of submission. FFB has room in every pixel for as many fragments as the deepest pixel has.
///
/// A box has the number of the fragment that it holds, in the order of submission. PPLL's records are taken from one
/// counter, so that they lie in this order, and each links to the one before it in its pixel.
pub fn memory_layout(title: &str, pixels: u32, fragments: &[u32]) -> Strips {
    let layout = Layout::of(pixels, fragments);
    let color = |pixel: usize| DISTINCT[pixel % DISTINCT.len()];
    let per_pixel = |values: &[String]| {
        let cells = values.iter().enumerate();
        let cells = cells.map(|(pixel, value)| Cell::new(color(pixel), value));
        cells.collect::<Vec<_>>()
    };
    let pool = |slots: &[Option<u32>]| {
        let cell = |slot: &Option<u32>| match slot {
            Some(fragment) => Cell::new(color(fragments[*fragment as usize] as usize), fragment),
            None => Cell::new(UNUSED, ""),
        };
        slots.iter().map(cell).collect::<Vec<_>>()
    };
    let row = |label: &str, cells| Strip {
        label: label.into(),
        cells,
        after: Vec::new(),
    };
    let counters = || row("counter per pixel", per_pixel(&texts(&layout.counts)));
    let places = |values: &[Option<u32>]| -> Vec<String> {
        let text = |value: &Option<u32>| value.map_or("–".into(), |value| value.to_string());
        values.iter().map(text).collect()
    };
    let owner = |place: usize| color(fragments[place] as usize);
    let links = layout.links.iter().enumerate();
    let links = links.map(|(place, link)| Cell::new(owner(place), &places(&[*link])[0]));
    let heading = |name: &str, slots: usize| {
        let room = format!(
            "{name}: room for {slots} fragments, {} are there",
            fragments.len()
        );
        Strip::heading(&room)
    };
    let rows = vec![
        heading("Fixed Fragment Buffers (FFB)", layout.fixed.len()),
        counters(),
        row("global memory", pool(&layout.fixed)),
        heading("Dynamic Fragment Buffers (DFB)", layout.dynamic.len()),
        counters(),
        row("base offset per pixel", per_pixel(&texts(&layout.bases))),
        row("global memory", pool(&layout.dynamic)),
        heading("Per-Pixel Linked Lists (PPLL)", layout.linked.len()),
        counters(),
        row("anchor per pixel", per_pixel(&places(&layout.anchors))),
        row("global memory", pool(&layout.linked)),
        row("link to the next", links.collect()),
    ];
    let mut key = Key::default();
    for pixel in 0..pixels as usize {
        key.push(color(pixel), &format!("pixel {pixel}"));
    }
    key.push(UNUSED, "unused");
    Strips {
        title: title.into(),
        heads: Default::default(),
        rows,
        cell: 34,
        key,
    }
}

fn texts(values: &[u32]) -> Vec<String> {
    values.iter().map(ToString::to_string).collect()
}

/// The three managers' memory. A slot has the number of its fragment.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Layout {
    counts: Vec<u32>,
    fixed: Vec<Option<u32>>,
    bases: Vec<u32>,
    dynamic: Vec<Option<u32>>,
    anchors: Vec<Option<u32>>,
    linked: Vec<Option<u32>>,
    links: Vec<Option<u32>>,
}

impl Layout {
    fn of(pixels: u32, fragments: &[u32]) -> Self {
        let mut counts = vec![0; pixels as usize];
        for &pixel in fragments {
            counts[pixel as usize] += 1;
        }
        let most = counts.iter().copied().max().unwrap_or(0);
        let mut bases = Vec::new();
        let mut sum = 0;
        for count in &counts {
            bases.push(sum);
            sum += count;
        }
        let mut layout = Self {
            fixed: vec![None; (pixels * most) as usize],
            bases,
            dynamic: vec![None; fragments.len()],
            anchors: vec![None; pixels as usize],
            linked: Vec::new(),
            links: Vec::new(),
            counts: vec![0; pixels as usize],
        };
        for (number, &pixel) in (0..).zip(fragments) {
            let counter = &mut layout.counts[pixel as usize];
            layout.fixed[(pixel * most + *counter) as usize] = Some(number);
            layout.dynamic[(layout.bases[pixel as usize] + *counter) as usize] = Some(number);
            *counter += 1;
            let anchor = &mut layout.anchors[pixel as usize];
            layout.links.push(*anchor);
            *anchor = Some(number);
            layout.linked.push(Some(number));
        }
        layout
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Plot;

    /// Pixel 0 has three fragments, pixel 1 none, pixel 2 two.
    const FRAGMENTS: [u32; 5] = [0, 2, 0, 0, 2];

    #[test]
    fn every_manager_has_each_fragment_once_and_finds_those_of_a_pixel() {
        let layout = Layout::of(3, &FRAGMENTS);
        let some = Some;
        assert_eq!(layout.counts, [3, 0, 2]);
        let fixed = [
            some(0),
            some(2),
            some(3),
            None,
            None,
            None,
            some(1),
            some(4),
            None,
        ];
        assert_eq!(layout.fixed, fixed);
        assert_eq!(layout.bases, [0, 3, 3]);
        assert_eq!(
            layout.dynamic,
            [some(0), some(2), some(3), some(1), some(4)]
        );
        assert_eq!(layout.anchors, [some(3), None, some(4)]);
        assert_eq!(layout.links, [None, None, some(0), some(2), some(1)]);
    }

    #[test]
    fn the_figure_says_how_much_room_there_is_and_whose_it_is() {
        let strips = memory_layout("title", 3, &FRAGMENTS);
        let [Plot::Svg(text), _] = strips.draw().unwrap() else {
            panic!("not an SVG")
        };
        for expected in [
            "(FFB): room for 9",
            "(DFB): room for 5",
            "(PPLL): room for 5",
            "pixel 2",
            "unused",
        ] {
            assert!(text.contains(expected), "no {expected}: {text}");
        }
        // FFB leaves four of its nine boxes unused, and the key has one more.
        let grey = r##"fill="#DDDDDD""##;
        assert_eq!(text.matches(grey).count(), 4 + 1, "{text}");
    }
}
