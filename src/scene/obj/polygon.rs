//! Covering polygons of more than three corners by triangles.

use glam::{DVec2, DVec3};

use super::cover::Cover;
use super::even_odd::{self, Effort};

/// Covers the inside of a polygon once. The triangles face the side from which the polygon is seen counter-clockwise. A
/// convex polygon becomes a fan. For any other the even-odd rule gives the inside, on the plane that fits the polygon
/// best.
pub(super) fn cover(places: &[DVec3], effort: &mut Effort) -> Cover {
    if places.len() == 3 {
        return Cover::Fan;
    }
    let Some(flat) = flattened(&scaled(places)) else {
        return Cover::Fan;
    };
    if is_convex(&flat) {
        return Cover::Fan;
    }
    even_odd::cover(&flat, places, effort)
}

/// Scales to coordinates of at most 1 by a power of two, which rounds nothing.
fn scaled(places: &[DVec3]) -> Vec<DVec3> {
    let largest = places.iter().map(|place| place.abs().max_element());
    let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
    // In two steps, because the power itself may be out of range.
    let half = (-largest.log2().ceil() / 2.0).ceil().exp2();
    places.iter().map(|&place| place * half * half).collect()
}

/// The distance from a plane, relative to the polygon's size, at which a corner still counts as on it. Numbers of six
/// digits, which most programs write, are not more exact.
const FLAT: f64 = 1e-5;

/// The polygon on a plane, on which it runs counter-clockwise. `None` if all corners are on a line.
///
/// The plane is the one that fits best. If the corners are on it, one coordinate is dropped. This shows the same
/// polygon at a slant and rounds nothing, so that corners on a line stay on it. A polygon that is not flat is projected
/// onto the plane.
fn flattened(places: &[DVec3]) -> Option<Vec<DVec2>> {
    let facing = facing(places)?;
    let axis = facing.abs().max_position();
    let up = facing.normalize();
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    let from_middle = |place: &DVec3| *place - middle;
    let sizes = places
        .iter()
        .map(|place| from_middle(place).abs().max_element());
    let off = places.iter().map(|place| from_middle(place).dot(up).abs());
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let is_flat = most(&mut off.into_iter()) <= FLAT * most(&mut sizes.into_iter());
    let clockwise = facing[axis] < 0.0;
    let (right, forward) = up.any_orthonormal_pair();
    let flat = places.iter().map(|&place| match (is_flat, clockwise) {
        (true, false) => DVec2::new(place[(axis + 1) % 3], place[(axis + 2) % 3]),
        (true, true) => DVec2::new(place[(axis + 2) % 3], place[(axis + 1) % 3]),
        (false, _) => DVec2::new(place.dot(right), place.dot(forward)),
    });
    Some(flat.collect())
}

/// The direction that a polygon faces. It is the sum of the areas of its fan, which does not depend on the fan. If the
/// sum is zero, as for a figure of eight with equal loops, it is an axis.
fn facing(places: &[DVec3]) -> Option<DVec3> {
    let (first, rest) = places.split_first()?;
    let mut sum = DVec3::ZERO;
    let mut size = DVec3::ZERO;
    for pair in rest.windows(2) {
        let area = (pair[0] - first).cross(pair[1] - first);
        sum += area;
        size += area.abs();
    }
    // If areas cancel each other, only rounding is left: n terms of 1e-16 each.
    let cancelled = sum.abs().max_element() <= 1e-16 * places.len() as f64 * size.max_element();
    let facing = if cancelled {
        DVec3::AXES[size.max_position()]
    } else {
        sum
    };
    (size.max_element() > 0.0 && facing.try_normalize().is_some()).then_some(facing)
}

/// Whether the polygon only turns left, goes around once, and every triangle of its fan has an area.
fn is_convex(flat: &[DVec2]) -> bool {
    let count = flat.len();
    let first = flat[0];
    let fan = flat[1..].windows(2);
    if !fan
        .into_iter()
        .all(|pair| (pair[0] - first).perp_dot(pair[1] - first) > 0.0)
    {
        return false;
    }
    let edges = (0..count).map(|i| flat[(i + 1) % count] - flat[i]);
    let next = edges.clone().cycle().skip(1);
    if edges
        .clone()
        .zip(next)
        .any(|(edge, next)| edge.perp_dot(next) < 0.0)
    {
        return false;
    }
    // A polygon that goes around once goes to the right once and to the left once.
    let sideways = || edges.clone().map(|edge| edge.x).filter(|&x| x != 0.0);
    let turned = sideways().zip(sideways().cycle().skip(1));
    turned
        .filter(|(x, next)| (*x > 0.0) != (*next > 0.0))
        .count()
        <= 2
}
