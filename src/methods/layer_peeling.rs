//! Layer peeling as Carr et al. (2008) count it: two geometry passes an iteration, one that finds the next depth and one
//! that composites what lies there.
//!
//! Everitt's depth peeling draws once per layer, because it composites the fragment that its depth test has kept. This
//! draws twice, and composites *every* fragment at the depth that was found: ties stay in the order of submission.

use super::peeled::{Peeled, peeled};
use super::{Algorithm, Drawn, allocate_maps};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::papers::carr_2008::hybrid;
use crate::scene::Scene;
use crate::steps::run;

/// What can be chosen about layer peeling and hybrid layer peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LayerPeelingOptions {
    /// The paper's text with nothing amended. Given up when it goes on for too long.
    pub as_printed: bool,
}

pub(super) struct LayerPeeling {
    pub(super) options: Peeled,
    pub(super) color: Format,
    pub(super) depth: Format,
}

impl Algorithm for LayerPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        self.options.prepare(machine)?;
        allocate_maps(machine, &hybrid::RESOURCES, self.color, self.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let outcome = run(
            &hybrid::LAYER_PEELING,
            self.options.amendments(&hybrid::AMENDMENTS),
            self.options.variables(),
            machine,
        )?;
        Ok(peeled(&outcome))
    }
}
