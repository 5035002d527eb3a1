//! Polygons of more than three corners, and how triangles cover them.

use glam::{DVec2, DVec3};

use super::cover::Cover;
use super::even_odd::{self, Effort};

/// Covers what lies within a polygon once, facing to where it is seen counter-clockwise. A convex one is a fan; of any
/// other the even-odd rule says what lies within, on the plane that fits it best.
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

/// By a power of two, which rounds nothing, to coordinates of at most 1.
fn scaled(places: &[DVec3]) -> Vec<DVec3> {
    let largest = places.iter().map(|place| place.abs().max_element());
    let largest = largest.fold(f64::MIN_POSITIVE, f64::max);
    // In two steps: the power itself may be out of range.
    let half = (-largest.log2().ceil() / 2.0).ceil().exp2();
    places.iter().map(|&place| place * half * half).collect()
}

/// How far corners may be from a plane, relative to the polygon's size, to be of it all the same: numbers of six digits,
/// as most programs write them, are no nearer.
const FLAT: f64 = 1e-5;

/// The polygon on a plane, where it runs counter-clockwise. `None` if all corners are on a line.
///
/// The plane is the one that fits best. One coordinate is dropped if the corners are on that plane, which shows the
/// same from a slant and rounds nothing, so that corners on a line stay on it; what is not flat is seen from above.
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

/// Where a polygon faces: along the sum of its fan's areas, which is its own whatever the shape; along an axis where the
/// sum is nothing, as that of an eight whose loops are alike.
fn facing(places: &[DVec3]) -> Option<DVec3> {
    let (first, rest) = places.split_first()?;
    let mut sum = DVec3::ZERO;
    let mut size = DVec3::ZERO;
    for pair in rest.windows(2) {
        let area = (pair[0] - first).cross(pair[1] - first);
        sum += area;
        size += area.abs();
    }
    // What is left of areas that cancel each other is rounding: n terms of 1e-16 each.
    let cancelled = sum.abs().max_element() <= 1e-16 * places.len() as f64 * size.max_element();
    let facing = if cancelled {
        DVec3::AXES[size.max_position()]
    } else {
        sum
    };
    (size.max_element() > 0.0 && facing.try_normalize().is_some()).then_some(facing)
}

/// Whether it turns to the left only, once around, and each triangle of its fan has an area.
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
    // Going around once it goes to the right once and to the left once.
    let sideways = || edges.clone().map(|edge| edge.x).filter(|&x| x != 0.0);
    let turned = sideways().zip(sideways().cycle().skip(1));
    turned
        .filter(|(x, next)| (*x > 0.0) != (*next > 0.0))
        .count()
        <= 2
}
