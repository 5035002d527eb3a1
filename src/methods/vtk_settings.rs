//! The switches of VTK's page, with their initial values: depth peeling is off at first, and cannot be had without alpha
//! bit planes.

use super::algorithm::{Algorithm, Drawn, Setup};
use super::blend::Blend;
use super::depth_peeling::DepthPeelingOptions;
use super::entry::Entry;
use super::stats::Peeling;
use super::technique::Technique;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::scene::Scene;

/// What a user of VTK sets on the window and on the renderer ("VTK calls"). Without both switches, translucent geometry is
/// blended in the order of submission, and [`Stats::peeling`](super::Stats::peeling) says why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VtkSettings {
    /// `vtkRenderWindow::SetAlphaBitPlanes`: "initial value is 0 (false)".
    pub alpha_bit_planes: bool,
    /// `vtkRenderer::SetUseDepthPeeling`: "initial value is 0 (false)".
    pub use_depth_peeling: bool,
    /// `vtkRenderer::SetMaximumNumberOfPeels`: "initial value is 4".
    pub maximum_number_of_peels: u32,
    /// `vtkRenderer::SetOcclusionRatio`: "initial value is 0.0, exact image".
    pub occlusion_ratio: f64,
}

impl Default for VtkSettings {
    fn default() -> Self {
        Self {
            alpha_bit_planes: false,
            use_depth_peeling: false,
            maximum_number_of_peels: 4,
            occlusion_ratio: 0.0,
        }
    }
}

impl VtkSettings {
    fn peeling(&self) -> DepthPeelingOptions {
        DepthPeelingOptions {
            maximum_number_of_peels: self.maximum_number_of_peels,
            occlusion_ratio: self.occlusion_ratio,
            ..Default::default()
        }
    }

    /// Why there is no depth peeling, or `None` if there is.
    fn why_not(&self) -> Option<Peeling> {
        match (self.use_depth_peeling, self.alpha_bit_planes) {
            (false, _) => Some(Peeling::SwitchedOff),
            (true, false) => Some(Peeling::NoAlphaBits),
            (true, true) => None,
        }
    }
}

impl Technique for VtkSettings {
    fn entry(&self) -> &'static Entry {
        match self.why_not() {
            Some(_) => Blend.entry(),
            None => self.peeling().entry(),
        }
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        match self.why_not() {
            Some(why) => Box::new(Blended(why)),
            None => self.peeling().algorithm(setup),
        }
    }

    fn check(&self) -> Result<()> {
        self.peeling().check()
    }
}

/// Blending, because there is no depth peeling.
struct Blended(Peeling);

impl Algorithm for Blended {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        Blend.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        Ok(Drawn {
            peeling: self.0,
            ..Blend.draw(machine, scene)?
        })
    }
}
