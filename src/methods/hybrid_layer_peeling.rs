//! Hybrid layer peeling (Carr et al. 2008, Algorithm 1): unsorted meshes are peeled, and between two peels the sorted
//! ones are composited in one go.
//!
//! Sorted are the meshes that the scene says are ([`Mesh::sorted`](crate::scene::Mesh::sorted)); the number of
//! iterations depends on the others alone. Of surfaces at the same depth, unsorted ones come before sorted ones.
//!
//! Volumes become sorted meshes, too: planes across the view, what Carr et al. have in their figure 1. A slice stands for
//! a slab as a whole, so that where a surface is in a slab, or a ray enters or leaves a volume there, up to half of it is
//! on the wrong side; the error of the image falls with the number of slices.

use super::peeled::{Peeled, peeled};
use super::sorting::sorted_meshes_front_to_back;
use super::{Algorithm, Drawn, allocate_maps};
use crate::error::Result;
use crate::gl::{Format, Geometry, GlMachine};
use crate::papers::carr_2008::hybrid;
use crate::scene::Scene;
use crate::steps::run;

pub(super) struct HybridLayerPeeling {
    pub(super) options: Peeled,
    pub(super) color: Format,
    pub(super) depth: Format,
}

impl Algorithm for HybridLayerPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        let order = sorted_meshes_front_to_back(scene);
        let geometry = Geometry::upload_in_order(machine.context(), scene, machine.size(), &order)?;
        machine.set_geometry(geometry);
        self.options.prepare(machine)?;
        allocate_maps(machine, &hybrid::RESOURCES, self.color, self.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let outcome = run(
            &hybrid::HYBRID,
            self.options.amendments(&hybrid::AMENDMENTS),
            self.options.variables(),
            machine,
        )?;
        Ok(peeled(&outcome))
    }
}
