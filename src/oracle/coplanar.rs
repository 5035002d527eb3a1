//! Deciding whether two triangles lie in one plane, whatever their corners are.
//!
//! The coordinates as given decide. A decimal number in f64, and a corner that a rotation has moved, are off by
//! roundings. So much, and no more, is allowed.

use glam::DVec3;

/// Roundings of a coordinate: one when it is read, three when it is moved ((a x + b y) + c z) + t, and as many in the
/// differences and products here.
const ROUNDINGS: f64 = 8.0;

/// Whether `a` and `b` lie in one plane, up to the rounding of their coordinates.
pub(super) fn coplanar(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    let (a_plane, b_plane) = (Plane::of(a), Plane::of(b));
    // The plane of the larger triangle is known more exactly.
    if a_plane.doubled_area >= b_plane.doubled_area {
        a_plane.holds(b)
    } else {
        b_plane.holds(a)
    }
}

struct Plane {
    point: DVec3,
    /// The normal, of unit length, or zero for a triangle without area.
    normal: DVec3,
    doubled_area: f64,
    longest_edge: f64,
    largest: f64,
}

impl Plane {
    fn of([a, b, c]: [DVec3; 3]) -> Self {
        let cross = (b - a).cross(c - a);
        let doubled_area = cross.length();
        let edges = [b - a, c - b, a - c].map(DVec3::length);
        Self {
            point: a,
            normal: cross.normalize_or_zero(),
            doubled_area,
            longest_edge: edges.into_iter().fold(0.0, f64::max),
            largest: largest([a, b, c]),
        }
    }

    /// Whether all points are in the plane. A corner that is off tilts the plane. At a point that is n heights of the
    /// triangle away, the plane is off by n times as much.
    fn holds(&self, points: [DVec3; 3]) -> bool {
        let height = self.doubled_area / self.longest_edge;
        if height.is_nan() || height <= 0.0 {
            return false;
        }
        let rounding = ROUNDINGS * f64::EPSILON * self.largest.max(largest(points));
        points.iter().all(|&point| {
            let from = point - self.point;
            let reach = 1.0 + from.length() / height;
            from.dot(self.normal).abs() <= rounding * reach
        })
    }
}

/// The largest absolute value of a coordinate.
fn largest(corners: [DVec3; 3]) -> f64 {
    let sizes = corners.map(|corner| corner.abs().max_element());
    sizes.into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The plane z = 0.1 x + 0.3 y, in decimal numbers that no f64 holds.
    fn slope(x: f64, y: f64) -> DVec3 {
        let hundredths = |v: f64| (v * 100.0).round();
        let z = (hundredths(x) * 10.0 + hundredths(y) * 30.0) / 10_000.0;
        DVec3::new(hundredths(x) / 100.0, hundredths(y) / 100.0, z)
    }

    fn wall() -> [DVec3; 3] {
        [slope(-3.0, -2.0), slope(5.0, -1.0), slope(0.7, 4.0)]
    }

    fn decal() -> [DVec3; 3] {
        [slope(0.13, 0.21), slope(0.58, 0.17), slope(0.31, 0.77)]
    }

    #[test]
    fn a_decal_lies_in_its_wall_however_the_decimals_were_rounded() {
        assert!(coplanar(wall(), decal()) && coplanar(decal(), wall()));
    }

    #[test]
    fn a_turned_and_moved_decal_still_does() {
        for degrees in 1..90 {
            let turn = glam::DQuat::from_axis_angle(
                DVec3::new(1.0, 2.0, -0.5).normalize(),
                f64::from(degrees).to_radians(),
            );
            let moved = |corner: DVec3| turn * corner + DVec3::new(4.0e5, 5.0e6, 13.0);
            let (wall, decal) = (wall().map(moved), decal().map(moved));
            assert!(coplanar(wall, decal), "{degrees}");
        }
    }

    #[test]
    fn a_decal_a_billionth_before_its_wall_does_not() {
        let before = decal().map(|corner| corner + DVec3::Z * 1e-9);
        assert!(!coplanar(wall(), before));
        let tilted = [decal()[0], decal()[1], decal()[2] + DVec3::Z * 1e-9];
        assert!(!coplanar(wall(), tilted));
    }

    #[test]
    fn a_triangle_without_area_has_no_plane() {
        let line = [DVec3::ZERO, DVec3::X, DVec3::X * 2.0];
        assert!(!coplanar(line, line));
    }
}
