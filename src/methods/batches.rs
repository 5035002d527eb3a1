//! Depth batches (Wexler et al. 2005, as Carr et al. 2008 propose in section 9): the view's depth range in pieces, each
//! with the triangles that reach into it.

use glam::DMat4;

use crate::scene::Scene;

/// A piece of the depth range, and what may be in it.
pub(super) struct Batch {
    /// Window depth where it begins, itself included.
    pub(super) begin: f32,
    /// Window depth where it ends, itself excluded; 1 for the last.
    pub(super) end: f32,
    /// Triangles as mesh and number, in their order.
    pub(super) order: Vec<[u32; 2]>,
}

/// How far a rasterised depth may be from the exact one: f32's rounding, several times over. A triangle too many costs
/// a little, one too few would be missed.
const SLACK: f64 = 1e-5;

/// Cuts the depth range into at most `count` batches of about equally many triangles, by the middle of each triangle's
/// depth range. Opaque triangles are in every batch.
pub(super) fn batches(
    scene: &Scene,
    [width, height]: [u32; 2],
    order: &[[u32; 2]],
    count: u32,
) -> Vec<Batch> {
    let camera = &scene.camera;
    let view_projection = camera.projection(width, height) * camera.view();
    let ranges: Vec<[f64; 2]> = order
        .iter()
        .map(|&[mesh, triangle]| {
            let mesh = &scene.meshes[mesh as usize];
            match mesh.opaque {
                true => [0.0, 1.0],
                false => depth_range(view_projection, mesh.corners(triangle as usize)),
            }
        })
        .collect();
    let mut middles: Vec<f32> = ranges
        .iter()
        .zip(order)
        .filter(|(_, [mesh, _])| !scene.meshes[*mesh as usize].opaque)
        .map(|([near, far], _)| ((near + far) / 2.0) as f32)
        .collect();
    middles.sort_unstable_by(f32::total_cmp);
    let mut cuts: Vec<f32> = (1..count as usize)
        .filter_map(|batch| middles.get(batch * middles.len() / count as usize).copied())
        .filter(|&cut| cut > 0.0 && cut < 1.0)
        .collect();
    cuts.dedup();
    let begins = std::iter::once(0.0).chain(cuts.iter().copied());
    let ends = cuts.iter().copied().chain(std::iter::once(1.0));
    begins
        .zip(ends)
        .map(|(begin, end)| {
            let reaches = |[near, far]: [f64; 2]| {
                near - SLACK <= f64::from(end) && far + SLACK >= f64::from(begin)
            };
            let inside = order
                .iter()
                .zip(&ranges)
                .filter(|(_, range)| reaches(**range));
            Batch {
                begin,
                end,
                order: inside.map(|(triangle, _)| *triangle).collect(),
            }
        })
        .collect()
}

/// Window depths between which a triangle lies; everything if it reaches behind the eye.
fn depth_range(view_projection: DMat4, corners: [crate::scene::Vertex; 3]) -> [f64; 2] {
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
