//! Depth peeling that draws only the triangles that may have something left to peel.

use super::super::culling::Extents;
use super::super::sorting::TriangleSort;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::stage::OPAQUE_DEPTH;
use crate::papers::vtk::DEPTH_BUFFERS;
use crate::scene::Scene;
use crate::steps::{Call, Machine, Objects, Query};

/// A machine that has its transparent objects drawn without the triangles that lie before the last layer wherever they are
/// seen, or where nothing is left. The listing does not know of it.
pub(super) struct Culled<'m, 'c> {
    machine: &'m mut GlMachine<'c>,
    scene: &'m Scene,
    extents: Extents,
    /// Row by row from the bottom, once there is a layer.
    opaque: Vec<f32>,
    peels: usize,
}

impl<'m, 'c> Culled<'m, 'c> {
    /// Nothing is peeled yet. The scene was uploaded in the order of submission.
    pub(super) fn new(machine: &'m mut GlMachine<'c>, scene: &'m Scene) -> Self {
        let extents = Extents::new(
            scene,
            machine.size(),
            &TriangleSort::Submission.order(scene),
        );
        Self {
            machine,
            scene,
            extents,
            opaque: Vec::new(),
            peels: 0,
        }
    }

    /// Has every triangle drawn again.
    pub(super) fn finish(self) -> Result<()> {
        self.machine.reorder(self.scene, &[self.extents.all()])
    }

    /// Depth buffer A, which the peel looks up, has the last layer's depth at the layer's pixels and the opaque depth at
    /// others, or 0 at those that are not alive ([`ALIVE`](crate::papers::vtk::ALIVE)). No layer but the first lies at 0.
    fn cull(&mut self) -> Result<()> {
        let mut bound = self.machine.read_depths(DEPTH_BUFFERS[self.peels % 2])?;
        if self.peels == 1 {
            self.opaque = self.machine.read_depths(OPAQUE_DEPTH)?;
        } else {
            let dead = bound.iter_mut().filter(|depth| **depth == 0.0);
            dead.for_each(|depth| *depth = 1.0);
        }
        let width = self.machine.size()[0];
        let left = self.extents.unfinished(&bound, &self.opaque, width);
        self.machine.reorder(self.scene, &[left])
    }
}

impl Machine for Culled<'_, '_> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        if let Call::Draw {
            objects: Objects::Transparent,
        } = call
        {
            if self.peels > 0 {
                self.cull()?;
            }
            self.peels += 1;
        }
        self.machine.perform(call)
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.machine.samples(query)
    }
}
