//! Figure 2's arrangement: where the eleven surfaces lie, and when they are drawn.

use std::fmt::Write;

use super::figure_2::FRONT_TO_BACK;
use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-2-order",
    source: "Carr et al. 2008, figure 2",
    title: "Eleven surfaces at one pixel: where they lie, and when they are drawn",
    make,
};

/// Pixels from one depth to the next, and from one surface to the next.
const ACROSS: usize = 52;
const DOWN: usize = 24;
const LEFT: usize = 60;
const TOP: usize = 34;
/// The places of s3, s_n, and of s10, which ends the run.
const RUN: [usize; 2] = [2, 5];

fn make(_: &Studio) -> Result<Drawn> {
    let mut drawn = String::new();
    for (place, surface) in FRONT_TO_BACK.iter().enumerate() {
        let (x, y) = (LEFT + place * ACROSS, TOP + surface * DOWN);
        let shape = match place {
            place if place < RUN[0] => "peeled",
            place if place < RUN[1] => "run",
            _ => "behind",
        };
        // Writing to a string cannot fail.
        let _ = write!(
            drawn,
            "<g class=\"{shape}\"><line x1=\"{x}\" x2=\"{x}\" y1=\"{up}\" y2=\"{down}\" /><text x=\"{text}\" y=\"{base}\">\
             s<tspan dy=\"3\" font-size=\"11\">{surface}</tspan></text></g>",
            up = y - 8,
            down = y + 8,
            text = x + 5,
            base = y + 5,
        );
    }
    let bottom = TOP + 11 * DOWN;
    let width = LEFT + 11 * ACROSS;
    let band = LEFT + RUN[0] * ACROSS - 8;
    let band_width = (RUN[1] - RUN[0]) * ACROSS;
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"15\" fill=\"#202020\" stroke=\"none\">\
         <style>.order .run line{{stroke:#0072b2;stroke-width:6}}.order .peeled line{{stroke:#888;stroke-width:3;\
         stroke-dasharray:3 3}}.order .behind line{{stroke:#d55e00;stroke-width:3}}</style><g class=\"order\">\
         <rect x=\"{band}\" y=\"{top}\" width=\"{band_width}\" height=\"{tall}\" fill=\"#0072b2\" opacity=\"0.12\" />\
         <text x=\"{band_text}\" y=\"18\">the run: s3, s5, s6</text>{drawn}\
         <path d=\"M{LEFT} {axis}H{arrow}l-8 -4v8l8 -4\" fill=\"none\" stroke=\"#202020\" />\
         <text x=\"{LEFT}\" y=\"{label}\">the eye</text><text x=\"{arrow}\" y=\"{label}\" text-anchor=\"end\">depth</text>\
         <text x=\"0\" y=\"{first}\">drawn</text><text x=\"0\" y=\"{second}\">first</text>\
         <text x=\"0\" y=\"{last}\">last</text></g></svg>",
        height = bottom + 34,
        top = TOP - 10,
        tall = bottom - TOP + 6,
        band_text = band + 4,
        axis = bottom + 8,
        arrow = width - 30,
        label = bottom + 28,
        first = TOP + 4,
        second = TOP + 22,
        last = TOP + 10 * DOWN + 5,
    );
    let drawn = Drawn::new(
        "Depth goes to the right, the order of drawing downwards. A run goes down and to the right without a break: s3, s5, \
         s6. s10 lies before s7 and s9, and is drawn after both, so the run ends where s10 lies: that is z_min_post. s1 and s2 \
         are drawn before s3 and lie behind it, and the nearer of them, s2, is z_min_prev. The paper does not print depths. \
         This is one of the 18 orders that fit all it says.",
    );
    Ok(drawn.drawing(
        svg,
        "eleven bars; from the eye on: s0 and s4, which are peeled, then the run s3, s5 and s6, then s10, s9, s7, s2, s1 and s8",
    ))
}
