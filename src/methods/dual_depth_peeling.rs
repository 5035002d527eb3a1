//! Dual depth peeling (Bavoil and Myers 2008), which peels a layer from the front and one from the back in every pass.
//!
//! [`DUAL_DEPTH_PEELING`] is the algorithm. A scene of N layers takes N/2 peels, rounded up, and one pass before them
//! that finds the first depths: N/2 + 1 geometry passes. The depths are 32-bit floats in a colour target for every
//! format of the depth buffer, so a fixed-point depth buffer does no harm.
//!
//! All fragments of equal depth are in the image, in the order of submission. The paper blends colours by MAX, which
//! would merge them.
//!
//! Excludes: multisampling; depths at or beyond the far plane, which GL clips.

use super::algorithm::{Algorithm, Composited, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::Setter;
use super::depth_peeling::{DepthPeelingOptions, OCCLUSION_RATIO, PEELS};
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::expect_known::expect_known;
use super::requirements;
use super::stats::Peeling;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::papers::bavoil_2008::{self as bavoil, DUAL_DEPTH_PEELING};
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Amendment, Machine, Reason, Variables, run};

/// Options of dual depth peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DualDepthPeelingOptions {
    /// The loop ends after so many peels, each of which takes two layers. 0, the default, means no limit. The layers
    /// that are left over lie in the middle, and are left out. (VTK also documents 0 as 'no limit', but then peels
    /// nothing. It blends the layers that its dual pass leaves over without sorting them.)
    pub maximum_number_of_peels: u32,
    /// The loop ends after a peel that changed fewer pixels than this part of the image, 0 to 1. That last peel is
    /// still composited. 0, the default, is exact.
    pub occlusion_ratio: f64,
    /// Amendments to the listings that run.
    pub amendments: &'static [Amendment],
}

struct DualDepthPeeling {
    options: DualDepthPeelingOptions,
    color: Format,
    /// The variables at the end of the last frame, by which the fragments that are left can be counted.
    end: Variables,
}

impl Algorithm for DualDepthPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        self.options.check()?;
        requirements::check(machine.context().driver(), self.color)?;
        // Depths are kept as colours.
        let depth = machine.format(stage::OPAQUE_DEPTH)?;
        allocate_maps(machine, &[&bavoil::RESOURCES], self.color, depth)?;
        expect_known(
            machine,
            &DUAL_DEPTH_PEELING,
            self.options.amendments,
            &[&bavoil::RESOURCES],
        )
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        if scene.meshes.iter().all(|mesh| mesh.opaque) {
            run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
            return Ok(Drawn {
                peeling: Peeling::NothingTransparent,
                ..Drawn::default()
            });
        }
        let peels = match self.options.maximum_number_of_peels {
            0 => f64::INFINITY,
            peels => f64::from(peels),
        };
        let [width, height] = machine.size();
        let variables = Variables::new()
            .with("num_passes", peels)
            .with("occlusion_ratio", self.options.occlusion_ratio)
            .with("window_area", f64::from(width) * f64::from(height));
        let outcome = run(
            &DUAL_DEPTH_PEELING,
            self.options.amendments,
            variables,
            machine,
        )?;
        let stopped = outcome.stopped.unwrap_or(Reason::PeelLimit);
        self.end = outcome.variables;
        Ok(Drawn {
            iterations: self.end.get("peels").unwrap_or(0.0) as u32,
            stopped: Some(stopped),
            composited: if stopped == Reason::EmptyLayer {
                Composited::All
            } else {
                Composited::Unknown
            },
            peeling: Peeling::Used,
            ..Drawn::default()
        })
    }

    /// The number of fragments between the depths of the peel that was not made.
    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        if drawn.composited == Composited::Unknown {
            run(
                &bavoil::COUNT_FRAGMENTS_LEFT,
                &[],
                self.end.clone(),
                machine,
            )?;
            drawn.composited = Composited::Lost(machine.samples(bavoil::FRAGMENTS_LEFT)?);
        }
        Ok(())
    }
}

const ENTRY: Entry = Entry {
    name: "dual-depth-peeling",
    source: "Bavoil and Myers 2008; VTK today",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrder,
    memory: Memory::Pixels,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for DualDepthPeelingOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(DualDepthPeeling {
            options: *self,
            color: setup.color,
            end: Variables::new(),
        })
    }

    fn check(&self) -> Result<()> {
        DepthPeelingOptions {
            occlusion_ratio: self.occlusion_ratio,
            ..Default::default()
        }
        .check()
    }
}

impl Published for DualDepthPeelingOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        PEELS.of(|o| &mut o.maximum_number_of_peels),
        OCCLUSION_RATIO.of(|o| &mut o.occlusion_ratio),
    ];
}
