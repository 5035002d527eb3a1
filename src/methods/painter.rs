//! The painter's algorithm: triangles sorted by their centroids, farthest first, then blended in that order.
//!
//! Right where no two triangles intersect or overlap in a cycle, and where the nearer centroid is the nearer triangle
//! (Carr et al. 2008, section 1: an object level approach).

use super::blend::BLEND_IN_ORDER;
use super::{Algorithm, Drawn};
use crate::error::Result;
use crate::gl::{Geometry, GlMachine};
use crate::scene::Scene;
use crate::steps::{Variables, run};

pub(super) struct Painter;

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

/// Every triangle as mesh and number, the one with the farthest centroid along the view direction first; of equally
/// far ones, the one submitted last, because the one submitted first lies in front.
fn back_to_front(scene: &Scene) -> Vec<[u32; 2]> {
    let forward = (scene.camera.target - scene.camera.eye).as_vec3();
    let mut keyed: Vec<(f32, [u32; 2])> = Vec::new();
    for (mesh_number, mesh) in scene.meshes.iter().enumerate() {
        let depth = |corner: u32| mesh.vertices[corner as usize].position.dot(forward);
        // Three times the centroid's depth; the factor does not change the order.
        let keys = mesh
            .triangles
            .iter()
            .map(|triangle| triangle.iter().map(|&corner| depth(corner)).sum());
        keyed.extend(
            keys.enumerate()
                .map(|(number, key): (_, f32)| (key, [mesh_number as u32, number as u32])),
        );
    }
    keyed.reverse();
    keyed.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    keyed.into_iter().map(|(_, triangle)| triangle).collect()
}
