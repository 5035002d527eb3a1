//! The triangles that cover a polygon.

use glam::DVec3;

/// The triangles of a polygon.
pub(super) enum Cover {
    /// A fan: the first corner with each two consecutive corners.
    Fan,
    /// A fan that may lie over itself, because inside and outside cannot be told apart.
    Tangled,
    /// Triangles of these corners. Numbers beyond the polygon's own corners are added corners.
    Triangles {
        triangles: Vec<[usize; 3]>,
        added: Vec<Point>,
        /// Whether edges of the polygon cross.
        crossed: bool,
    },
}

/// The crossing of two edges.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) place: DVec3,
    /// The corners at the ends of one of the edges.
    pub(super) between: [usize; 2],
    /// The place of the crossing between them, from 0 to 1.
    pub(super) at: f64,
}
