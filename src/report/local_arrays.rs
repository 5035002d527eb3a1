//! Figure 5 of Lindholm et al. 2015: what static arrays, ppAO and ppDP reserve for a heavy and a light pixel, and use.

use super::key::Key;
use super::palette::{DISTINCT, UNUSED};
use super::strips::{Cell, Strip, Strips};
use crate::low_level::emulator::Resolved;

/// Rows of reserved elements for each component, first of the heavy pixel, then of the light one. `lists` has the
/// lengths of their Fragment Lists. What a component did comes from a run on these lists.
pub fn local_arrays(title: &str, lists: [u32; 2], runs: &[(&str, [&Resolved; 2])]) -> Strips {
    let [heavy, light] = [DISTINCT[4], DISTINCT[0]];
    let row = |label: &str, color, used: u32, reserved: u32, after: String| {
        let cell = |place| match place < used {
            true => Cell::new(color, ""),
            false => Cell::new(UNUSED, ""),
        };
        Strip {
            label: label.into(),
            cells: (0..reserved).map(cell).collect(),
            after: vec![after],
        }
    };
    let mut rows = vec![Strip::heading("Fragment List, in global memory")];
    for (name, color, length) in [
        ("heavy pixel", heavy, lists[0]),
        ("light pixel", light, lists[1]),
    ] {
        rows.push(row(
            name,
            color,
            length,
            length,
            format!("{length} fragments"),
        ));
    }
    for (name, pixels) in runs {
        rows.push(Strip::heading(&format!("{name}: Local Array")));
        let pixels = [
            ("heavy pixel", heavy, pixels[0]),
            ("light pixel", light, pixels[1]),
        ];
        for (label, color, done) in pixels {
            let [reserved, used] = done.slots;
            let walks = match done.subpasses {
                1 => String::new(),
                more => format!(", filled {more} times"),
            };
            let after = format!("{used} of {reserved} used{walks}");
            rows.push(row(label, color, used, reserved, after));
        }
    }
    let mut key = Key::default();
    key.push(heavy, "heavy pixel");
    key.push(light, "light pixel");
    key.push(UNUSED, "reserved and unused");
    Strips {
        title: title.into(),
        heads: Default::default(),
        rows,
        cell: 15,
        key,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::Plot;

    #[test]
    fn there_is_a_box_for_each_reserved_element() {
        let done = |reserved, used, subpasses| Resolved {
            slots: [reserved, used],
            subpasses,
            ..Resolved::default()
        };
        let (large, small) = (done(16, 11, 1), done(8, 3, 2));
        let strips = local_arrays("title", [11, 3], &[("static", [&large, &small])]);
        let [Plot::Svg(text), _] = strips.draw().unwrap() else {
            panic!("not an SVG")
        };
        // Each has one more in the key.
        for (color, count) in [
            ("#0072B2", 11 + 11 + 1),
            ("#E69F00", 3 + 3 + 1),
            ("#DDDDDD", 5 + 5 + 1),
        ] {
            let fill = format!("fill=\"{color}\"");
            assert_eq!(text.matches(&fill).count(), count, "{color}: {text}");
        }
        for expected in [
            "11 of 16 used\n",
            "3 of 8 used, filled 2 times\n",
            "static: Local Array",
        ] {
            assert!(text.contains(expected), "no {expected}: {text}");
        }
    }
}
