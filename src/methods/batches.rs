//! Depth batches (Wexler et al. 2005, as Carr et al. 2008 propose in section 9): the view's depth range in pieces, each
//! with the triangles that reach into it.

use super::culling::depth_range;
use crate::error::Result;
use crate::papers::carr_2008::coherent::{BATCH_END, NEXT_BOUND};
use crate::papers::carr_2008::{BOUND, D_SC};
use crate::papers::stage::OPAQUE_DEPTH;
use crate::scene::Scene;
use crate::steps;
use crate::steps::{Call, Dialect, Listing, Variables, Workspace, gl::*, run};

/// A piece of the depth range.
pub(super) struct Batch {
    /// The window depth at which it begins, included.
    pub(super) begin: f32,
    /// The window depth at which it ends, excluded. It is 1 for the last batch.
    pub(super) end: f32,
}

/// Cuts the depth range into at most `count` batches of about equally many transparent triangles, by the middle of each
/// triangle's depth range. With the batches come the triangles that reach into each, as mesh and number, in their order.
pub(super) fn batches(
    scene: &Scene,
    size: [u32; 2],
    order: &[[u32; 2]],
    count: u32,
) -> (Vec<Batch>, Vec<Vec<[u32; 2]>>) {
    let camera = &scene.camera;
    let [width, height] = size;
    let view_projection = camera.projection(width, height) * camera.view();
    let is_transparent = |[mesh, _]: &&[u32; 2]| !scene.meshes[*mesh as usize].opaque;
    let transparent = order.iter().filter(is_transparent);
    let with_range = transparent.map(|&[mesh, triangle]| {
        let corners = scene.meshes[mesh as usize].corners(triangle as usize);
        (
            [mesh, triangle],
            depth_range(view_projection, corners, size),
        )
    });
    let triangles: Vec<([u32; 2], [f64; 2])> = with_range.collect();
    let mut middles: Vec<f32> = triangles
        .iter()
        .map(|(_, [near, far])| ((near + far) / 2.0) as f32)
        .collect();
    middles.sort_unstable_by(f32::total_cmp);
    let mut cuts: Vec<f32> = (1..count as usize)
        .filter_map(|batch| middles.get(batch * middles.len() / count as usize).copied())
        .filter(|&cut| cut > 0.0 && cut < 1.0)
        .collect();
    cuts.dedup();
    let begins = std::iter::once(0.0).chain(cuts.iter().copied());
    let ends = cuts.iter().copied().chain(std::iter::once(1.0));
    let batches: Vec<Batch> = begins
        .zip(ends)
        .map(|(begin, end)| Batch { begin, end })
        .collect();
    let inside = |batch: &Batch| {
        let reaches = |(_, [near, far]): &&([u32; 2], [f64; 2])| {
            *near <= f64::from(batch.end) && *far >= f64::from(batch.begin)
        };
        let inside = triangles.iter().filter(reaches);
        inside.map(|(triangle, _)| *triangle).collect()
    };
    let orders = batches.iter().map(inside).collect();
    (batches, orders)
}

/// Sets `D(sc)` to a batch's beginning, which belongs to it, and [`BATCH_END`] to its end, which does not. Window depths.
/// The workspace has [`RESOURCES_A`](crate::papers::carr_2008::coherent::RESOURCES_A), or those of variant B.
///
/// # Errors
/// What the machine cannot do.
pub fn begin_batch(workspace: &mut impl Workspace, begin: f32, end: f32) -> Result<()> {
    clear_bound(workspace, end)?;
    run(&NEARER_OF_BOTH, &[], Variables::new(), workspace)?;
    clear_bound(workspace, begin)
}

fn clear_bound(workspace: &mut impl Workspace, depth: f32) -> Result<()> {
    let depth = f64::from(depth);
    workspace.perform(&Call::ClearDepth { depth })?;
    run(&CLEAR_BOUND, &[], Variables::new(), workspace)?;
    Ok(())
}

const CLEAR_BOUND: Listing = Listing {
    title: "A depth everywhere",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BOUND);
        glDepthMask(true);
        glClear(DEPTH_BUFFER_BIT);
    },
};

const NEARER_OF_BOTH: Listing = Listing {
    title: "The batch's end, or the opaque depth where that is nearer",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glCopyImageSubData(D_SC, BATCH_END);
        glDisable(STENCIL_TEST);
        glEnable(DEPTH_TEST);
        glDepthFunc(ALWAYS);
        glUseProgram(NEXT_BOUND);
        glActiveTexture(2);
        glBindTexture(BATCH_END);
        glActiveTexture(3);
        glBindTexture(BATCH_END);
        glActiveTexture(4);
        glBindTexture(OPAQUE_DEPTH);
        drawScreen();
        glCopyImageSubData(D_SC, BATCH_END);
    },
};
