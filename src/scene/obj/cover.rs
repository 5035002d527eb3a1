//! How triangles cover a polygon.

use glam::DVec3;

/// What a polygon is drawn as.
pub(super) enum Cover {
    /// The first corner with each two that follow each other.
    Fan,
    /// The same, though it may lie over itself: what is inside cannot be told.
    Tangled,
    /// These corners. Those beyond the polygon's own are the added ones.
    Triangles {
        triangles: Vec<[usize; 3]>,
        added: Vec<Point>,
        /// Whether edges cross.
        crossed: bool,
    },
}

/// Where two edges cross.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) place: DVec3,
    /// The corners at the ends of one of the edges.
    pub(super) between: [usize; 2],
    /// How far it is from the first to the second, from 0 to 1.
    pub(super) at: f64,
}
