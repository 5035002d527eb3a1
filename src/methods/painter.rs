//! The painter's algorithm: triangles sorted by their centroids, farthest first, then blended in that order.
//!
//! Right where no two triangles intersect or overlap in a cycle, and where the nearer centroid is the nearer triangle
//! (Carr et al. 2008, section 1: an object level approach).
//!
//! Triangles are sorted up front, for one view, as those of coherent layer peeling are; a frame's time contains neither the
//! sort nor the upload.

use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::blend::BLEND_IN_ORDER;
use super::entry::{Entry, Memory, Ties, Volumes};
use super::sorting::centroid_depth;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::GlMachine;
use crate::scene::Scene;
use crate::steps::{Variables, run};

/// The painter's algorithm, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Painter;

impl Algorithm for Painter {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        DrawOrder::Sorted(back_to_front(scene))
    }

    fn prepare(&mut self, _: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        Ok(())
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        run(&BLEND_IN_ORDER, &[], Variables::new(), machine)?;
        Ok(Drawn {
            iterations: 1,
            ..Drawn::default()
        })
    }
}

/// Every triangle as mesh and number. The triangle with the farthest centroid along the view direction comes first. Of
/// equally far ones, the one submitted last comes first, because the one submitted first lies in front.
fn back_to_front(scene: &Scene) -> Vec<[u32; 2]> {
    let mut keyed: Vec<(f64, [u32; 2])> = Vec::new();
    for (mesh_number, mesh) in scene.meshes.iter().enumerate() {
        let key = |triangle: &[u32; 3]| centroid_depth(scene, mesh, *triangle);
        keyed.extend(
            (0..)
                .zip(mesh.triangles.iter().map(key))
                .map(|(number, key)| (key, [mesh_number as u32, number])),
        );
    }
    keyed.reverse();
    keyed.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    keyed.into_iter().map(|(_, triangle)| triangle).collect()
}

const ENTRY: Entry = Entry {
    name: "painter",
    source: "Carr et al. 2008, section 1",
    exact: false,
    exactness: "no",
    ties: Ties::OverEarlier,
    memory: Memory::PixelsAndTriangles,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for Painter {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, _: &Setup) -> Box<dyn Algorithm> {
        Box::new(Self)
    }
}

impl Published for Painter {}
