//! The ideal GPU's coherent layer peeling (Carr et al. 2008, Algorithm 2): two geometry passes an iteration.
//!
//! It asks for a rasteriser whose shaders read and write several buffers in the order of submission. Drivers with
//! `GL_EXT_shader_framebuffer_fetch` have one. The paper's pseudocode itself runs on the emulated pixel.

use super::peeled::{Peeled, peeled};
use super::sorting::Sorting;
use super::{Algorithm, Composited, Drawn};
use crate::error::{Error, Result};
use crate::gl::{Geometry, GlMachine};
use crate::papers::carr_2008::ideal;
use crate::papers::vtk;
use crate::scene::Scene;
use crate::steps::run;

/// The extension that makes a GPU ideal.
pub(super) const NEEDS: &[&str] = &["GL_EXT_shader_framebuffer_fetch"];

/// What can be chosen about it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IdealOptions {
    /// How triangles are sorted beforehand.
    pub sorting: Sorting,
    /// An improvement: an unbroken run ends at the loose bound `z2` ([`ideal::TIGHT_BOUND`]).
    pub tight_bound: bool,
    /// Algorithm 2 with nothing amended. Given up when it goes on for too long.
    pub as_printed: bool,
}

pub(super) struct IdealCoherentLayerPeeling {
    pub(super) options: IdealOptions,
    pub(super) peeled: Peeled,
}

impl Algorithm for IdealCoherentLayerPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        let driver = machine.context().driver();
        if let Some(missing) = NEEDS.iter().find(|extension| !driver.has(extension)) {
            return Err(Error::Driver {
                what: format!("this driver is no ideal GPU: it has no {missing}"),
                remedy: "Mesa's llvmpipe has it; coherent-layer-peeling-a runs everywhere".into(),
            });
        }
        let order = self.options.sorting.order(scene);
        let geometry = Geometry::upload_in_order(machine.context(), scene, machine.size(), &order)?;
        machine.set_geometry(geometry);
        self.peeled.prepare(machine)?;
        ideal::furnish(machine)?;
        machine.target(vtk::COMPOSITE, Some(super::renderer::IMAGE), None)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let amendments = match self.options.tight_bound {
            true => self.peeled.amendments(&ideal::TIGHT_BOUND_ON_GL),
            false => self.peeled.amendments(&ideal::AMENDMENTS),
        };
        let outcome = run(&ideal::IDEAL, amendments, self.peeled.variables(), machine)?;
        Ok(Drawn {
            // Its shaders composite without blending or discarding, so no query tells.
            composited: match self.options.as_printed {
                true => Composited::Unknown,
                false => Composited::All,
            },
            ..peeled(&outcome)
        })
    }
}
