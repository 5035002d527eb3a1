//! What rounding alone may do: the origin of the tests' tolerances.

/// A last place of numbers from 1 to 2 as f32. Numbers of at most 1 are rounded by a quarter of it or less.
const ULP: f64 = 1.0 / (1 << 23) as f64;

/// How far an f32 colour, composited of so many fragments, may be from the exact one, as f32.
///
/// The sum is at most 1 and is rounded once a fragment, by a quarter of an [`ULP`]; so is the exact colour. A summand is
/// colour times alpha times the light that is left: 3 roundings, and 2 more in that light for every fragment before it,
/// half of an ULP each, relative to the summand; and all summands together are at most 1.
pub const fn composited(fragments: u32) -> f64 {
    let fragments = fragments as f64;
    ((fragments + 1.0) / 4.0 + (3.0 + 2.0 * fragments) / 2.0) * ULP
}

/// The bound of pixels of at most 64 fragments. Scenes that have more keep to it, too, because the light that is left
/// shrinks: what lies deeper adds less and less.
pub const F32: f64 = composited(64);

/// How far a surface's distance may be off that was drawn at a depth of f32, at a distance of at most 6 behind a near
/// plane at `near`: half of a last place of depths from 1/2 to 1, times how fast distance grows with depth.
pub const fn distance(near: f64) -> f64 {
    6.0 * 6.0 / near * ULP / 4.0
}
