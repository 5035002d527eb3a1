//! `weighted/accumulate.frag`: a fragment's part of the sums of equation 6.

use crate::low_level::emulator::invocation::{Inputs, Outputs, keep_all};

fn square(x: f32) -> f32 {
    x * x
}

fn cube(x: f32) -> f32 {
    x * x * x
}

fn weight(i: &Inputs<'_>, alpha: f32) -> f32 {
    let z = i.distance() as f32;
    let by_distance = |weight: f32| alpha * weight.clamp(1e-2, 3e3);
    let far_away = square(cube(z / 200.0));
    match i.define("EQUATION") {
        7 => by_distance(10.0 / (1e-5 + square(z / 5.0) + far_away)),
        8 => by_distance(10.0 / (1e-5 + cube(z / 10.0) + far_away)),
        9 => by_distance(0.03 / (1e-5 + square(square(z / 200.0)))),
        _ => alpha * (3e3 * cube(1.0 - i.depth())).max(1e-2),
    }
}

pub(in super::super) fn main(i: &Inputs<'_>) -> Outputs {
    let [r, g, b, a] = i.surface_color();
    let weight = weight(i, a);
    let accumulated = [r * a, g * a, b * a, a].map(|channel| channel * weight);
    keep_all([accumulated, [a; 4]])
}
