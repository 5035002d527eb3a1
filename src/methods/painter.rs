//! The painter's algorithm: triangles sorted by their centroids, farthest first, then blended in that order.
//!
//! It is right if no two triangles intersect or overlap in a cycle, and if the triangle with the nearer centroid is the
//! nearer one (Carr et al. 2008, section 1: an object level approach).

use super::algorithm::{Algorithm, Drawn, Setup};
use super::blend::BLEND_IN_ORDER;
use super::entry::{Entry, Memory, Ties, Volumes};
use super::sorting::centroid_depth;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Geometry, GlMachine};
use crate::scene::Scene;
use crate::steps::{Variables, run};

/// The painter's algorithm, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Painter;

impl Algorithm for Painter {
    fn prepare(&mut self, _: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        Ok(())
    }

    /// Sorting depends on the view, so it is part of the frame.
    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let order = back_to_front(scene);
        machine.set_geometry(Geometry::upload_in_order(
            machine.context(),
            scene,
            machine.size(),
            &order,
        )?);
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
