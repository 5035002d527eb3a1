//! Culling of what is finished (Carr et al. 2008, section 9: "exploitation of z-culling in the context of coherent layer
//! peeling is still an area of future work"). A triangle that lies before `D(sc)` in all of its pixels has been
//! composited, and need not be drawn again. In depth peeling, the last layer's depth is the bound.
//!
//! The bound is read back after every iteration. A GPU would keep it in a hierarchical depth buffer.

use glam::{DMat4, DVec3, DVec4};

use crate::scene::Scene;

/// The largest distance of a rasterised depth from the exact one: several times f32's rounding. A triangle too many
/// costs a little, but one too few would be missing.
pub(super) const SLACK: f64 = 1e-5;

/// The side of a tile of pixels that are finished or not together.
const TILE: usize = 8;

/// Where triangles lie in the image, and how deep.
pub(super) struct Extents {
    across: usize,
    down: usize,
    /// Every triangle as mesh and number, with its extent, or `None` if it is always drawn.
    triangles: Vec<([u32; 2], Option<Extent>)>,
}

/// The first and the last column and row of tiles, and the farthest window depth that a rasteriser may give it.
struct Extent {
    columns: [usize; 2],
    rows: [usize; 2],
    far: f64,
}

impl Extents {
    /// The triangles in their order. Opaque ones are always drawn.
    pub(super) fn new(scene: &Scene, [width, height]: [u32; 2], order: &[[u32; 2]]) -> Self {
        let camera = &scene.camera;
        let view_projection = camera.projection(width, height) * camera.view();
        let [across, down] = [width, height].map(|side| (side as usize).div_ceil(TILE));
        let extent = |&[mesh, triangle]: &[u32; 2]| {
            let of = &scene.meshes[mesh as usize];
            let corners = of.corners(triangle as usize);
            let size = [width, height];
            let extent = (!of.opaque).then(|| extent(view_projection, corners, size));
            ([mesh, triangle], extent)
        };
        Self {
            across,
            down,
            triangles: order.iter().map(extent).collect(),
        }
    }

    /// Every triangle in its order.
    pub(super) fn all(&self) -> Vec<[u32; 2]> {
        self.triangles
            .iter()
            .map(|(triangle, _)| *triangle)
            .collect()
    }

    /// The triangles that are not finished. `bound` is every pixel's `D(sc)`, and `opaque` its opaque depth, row by row
    /// from the bottom.
    pub(super) fn unfinished(&self, bound: &[f32], opaque: &[f32], width: u32) -> Vec<[u32; 2]> {
        let mut nearest = vec![f64::INFINITY; self.across * self.down];
        for (pixel, (&bound, &opaque)) in bound.iter().zip(opaque).enumerate() {
            // What has reached the opaque surface, or the far plane, is finished.
            if bound < opaque {
                let (x, y) = (pixel % width as usize, pixel / width as usize);
                let tile = &mut nearest[y / TILE * self.across + x / TILE];
                *tile = tile.min(f64::from(bound));
            }
        }
        let is_open = |extent: &Extent| {
            (extent.rows[0]..=extent.rows[1]).any(|row| {
                let tiles = &nearest[row * self.across..][extent.columns[0]..=extent.columns[1]];
                tiles.iter().any(|&nearest| nearest <= extent.far + SLACK)
            })
        };
        let open = self.triangles.iter();
        open.filter(|(_, extent)| extent.as_ref().is_none_or(is_open))
            .map(|(triangle, _)| *triangle)
            .collect()
    }
}

/// The whole image if the triangle reaches behind the eye.
fn extent(view_projection: DMat4, corners: [crate::scene::Vertex; 3], size: [u32; 2]) -> Extent {
    let [_, far] = depth_range(view_projection, corners);
    let clip = corners.map(|corner| view_projection * corner.position.extend(1.0));
    let behind = clip.iter().any(|corner| corner.w <= 0.0);
    let [columns, rows] = [0, 1].map(|axis| {
        let last = f64::from(size[axis] - 1);
        let places = clip.map(|corner| (corner[axis] / corner.w + 1.0) / 2.0 * (last + 1.0));
        let low = places.into_iter().fold(f64::INFINITY, f64::min);
        let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max);
        // A pixel more on each side, for roundings.
        let range = if behind {
            [0.0, last]
        } else {
            [low - 1.0, high + 1.0]
        };
        range.map(|place| place.clamp(0.0, last) as usize / TILE)
    });
    let far = far + beyond(clip, size);
    Extent { columns, rows, far }
}

/// By how much a fragment may lie behind the farthest corner of a triangle before the eye. A corner is moved by up to half
/// of 1/256 pixel along each axis, and the plane goes on over the moved edge. And its slopes are quotients of differences of
/// products in f32, which in a sliver are far larger than their differences.
fn beyond(clip: [DVec4; 3], [width, height]: [u32; 2]) -> f64 {
    let size = DVec3::new(f64::from(width), f64::from(height), 1.0);
    let window = clip.map(|corner| corner.truncate() / corner.w * size / 2.0);
    let [along, across] = [window[1] - window[0], window[2] - window[0]];
    let normal = along.cross(across);
    let box_of = window[0].max(window[1]).max(window[2]) - window[0].min(window[1]).min(window[2]);
    let moved = (normal.x.abs() + normal.y.abs()) / 512.0;
    // Two products for each slope, two for the area, of three roundings each.
    let rounded = 18.0 * 2.0_f64.powi(-24) * box_of.x * box_of.y * box_of.z;
    let beyond = (moved + rounded) / normal.z.abs();
    // A triangle that is seen edge on has no area, and is not worth a thought.
    if beyond.is_finite() { beyond } else { 1.0 }
}

/// The window depths between which a triangle lies, or the whole range if it reaches behind the eye.
pub(super) fn depth_range(view_projection: DMat4, corners: [crate::scene::Vertex; 3]) -> [f64; 2] {
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for corner in corners {
        let clip = view_projection * corner.position.extend(1.0);
        if clip.w <= 0.0 {
            return [0.0, 1.0];
        }
        let depth = clip.z / clip.w * 0.5 + 0.5;
        range = [range[0].min(depth), range[1].max(depth)];
    }
    range
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fragment_may_lie_behind_the_farthest_corner_by_the_slope_over_half_a_step() {
        // In a window of 20 x 20 pixels: 10 pixels along x and along y, and 0.1 deep along x.
        let corner = |x: f64, y: f64, z: f64| DVec4::new(x / 10.0, y / 10.0, 2.0 * z, 1.0);
        let of = |[a, b, c]: [DVec4; 3]| beyond([a, b, c], [20, 20]);
        let beyond = of([
            corner(0.0, 0.0, 0.0),
            corner(10.0, 0.0, 0.1),
            corner(0.0, 10.0, 0.0),
        ]);
        let rounded = 18.0 * 2.0_f64.powi(-24) * 0.1;
        assert!(
            (beyond - (0.01 / 512.0 + rounded)).abs() < 1e-12,
            "{beyond}"
        );
        // Edge on.
        let edge = [0.0, 1.0, 2.0].map(|part| corner(part, part, part * part / 10.0));
        assert_eq!(of(edge), 1.0);
    }
}
