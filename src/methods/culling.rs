//! Culling of what is finished (Carr et al. 2008, section 9: "exploitation of z-culling in the context of coherent layer
//! peeling is still an area of future work"). A triangle that lies before `D(sc)` in all of its pixels has been
//! composited, and need not be drawn again. In depth peeling, the last layer's depth is the bound.
//!
//! The bound is read back after every iteration. A GPU would keep it in a hierarchical depth buffer.

use glam::{DMat4, DVec3};

use crate::oracle::surfaces::interpolation_error;
use crate::scene::{Scene, Vertex};

/// The largest distance of a rasterised depth from the exact one, but for what a triangle's shape adds ([`beyond`]): several
/// times f32's rounding. A triangle too many costs a little, but one too few would be missing.
const SLACK: f64 = 1e-5;

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
                tiles.iter().any(|&nearest| nearest <= extent.far)
            })
        };
        let open = self.triangles.iter();
        open.filter(|(_, extent)| extent.as_ref().is_none_or(is_open))
            .map(|(triangle, _)| *triangle)
            .collect()
    }
}

/// The whole image if the triangle reaches behind the eye.
fn extent(view_projection: DMat4, corners: [Vertex; 3], size: [u32; 2]) -> Extent {
    let [_, far] = depth_range(view_projection, corners, size);
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
    Extent { columns, rows, far }
}

/// The window depths between which a rasteriser may give a triangle fragments, or the whole range if it reaches behind the
/// eye.
pub(super) fn depth_range(
    view_projection: DMat4,
    corners: [Vertex; 3],
    [width, height]: [u32; 2],
) -> [f64; 2] {
    let clip = corners.map(|corner| view_projection * corner.position.extend(1.0));
    if clip.iter().any(|corner| corner.w <= 0.0) {
        return [0.0, 1.0];
    }
    let size = DVec3::new(f64::from(width), f64::from(height), 1.0);
    let window = clip.map(|corner| (corner.truncate() / corner.w + 1.0) / 2.0 * size);
    let depths = window.map(|corner| corner.z);
    let near = depths.into_iter().fold(f64::INFINITY, f64::min);
    let far = depths.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let beyond = SLACK + beyond(window);
    [near - beyond, far + beyond]
}

/// By how much a fragment's depth may lie beyond those of a triangle's corners, which are pixels and window depths. A corner
/// is moved by up to half of 1/256 pixel along each axis, and the plane goes on over the moved edge. And its slopes are
/// rounded.
fn beyond(window: [DVec3; 3]) -> f64 {
    let normal = (window[1] - window[0]).cross(window[2] - window[0]);
    let moved = (normal.x.abs() + normal.y.abs()) / normal.z.abs() / 512.0;
    let beyond = moved + interpolation_error(&window.map(|corner| corner.to_array()));
    // A triangle that is seen edge on has no area, and is not worth a thought.
    if beyond.is_finite() { beyond } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fragment_may_lie_behind_the_farthest_corner_by_the_slope_over_half_a_step() {
        // 10 pixels along x and along y, and 0.1 deep along x.
        let triangle = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.1], [0.0, 10.0, 0.0]];
        let rounded = interpolation_error(&triangle);
        let beyond = |triangle: [[f64; 3]; 3]| beyond(triangle.map(DVec3::from_array));
        let off = beyond(triangle) - (0.01 / 512.0 + rounded);
        assert!(off.abs() < 1e-12 && rounded > 1e-7, "{off} {rounded}");
        // Edge on.
        assert_eq!(
            beyond([0.0, 1.0, 2.0].map(|part| [part, part, part * part / 10.0])),
            1.0
        );
    }
}
