//! Depth peeling that loses no coplanar fragment (after Vasilakis and Fudos 2013).
//!
//! [`COPLANAR_PEELING`] is the algorithm. A layer takes two geometry passes: one finds its depth, and one takes every
//! fragment at that depth, in the order of submission. So it costs up to twice as much as plain depth peeling. The
//! second pass is the cheaper one, because its depth test is EQUAL.
//!
//! Excludes: multisampling; depths at or beyond the far plane, which GL clips.

use super::algorithm::{Algorithm, Composited, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::Setter;
use super::depth_peeling::PEELS;
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::iteration_bound::iteration_bound;
use super::requirements;
use super::stats::Peeling;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::papers::stage;
use crate::papers::vasilakis_2013::{COPLANAR_PEELING, RESOURCES};
use crate::scene::Scene;
use crate::steps::{DepthUnits, Reason, Variables, run};

/// Options of coplanar depth peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CoplanarDepthPeelingOptions {
    /// The loop ends after so many peels. 0, the default, means no limit.
    pub maximum_number_of_peels: u32,
}

struct CoplanarDepthPeeling {
    options: CoplanarDepthPeelingOptions,
    color: Format,
    depth: Format,
    /// The number of peels that a loop without a limit may need.
    bound: f64,
}

impl Algorithm for CoplanarDepthPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        requirements::check(machine.context().driver(), self.color)?;
        // With rounded depths, the same layer may be peeled for ever.
        if self.options.maximum_number_of_peels == 0 && !self.depth.has_float_depth() {
            self.bound = iteration_bound(machine)?;
        }
        allocate_maps(machine, &[&RESOURCES], self.color, self.depth)
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
            0 => self.bound,
            peels => f64::from(peels),
        };
        let outcome = run(
            &COPLANAR_PEELING,
            &[],
            Variables::new().with("num_passes", peels),
            &mut DepthUnits::new(machine),
        )?;
        let number = |name| outcome.variables.get(name).unwrap_or(0.0);
        let stopped = match (outcome.stopped, self.options.maximum_number_of_peels) {
            (Some(reason), _) => reason,
            (None, 0) => Reason::NoEnd,
            (None, _) => Reason::PeelLimit,
        };
        Ok(Drawn {
            iterations: number("peels") as u32,
            layers: Some(number("num_layers") as u32),
            composited: match stopped {
                // Layers have been counted more than once.
                Reason::NoEnd => Composited::Unknown,
                _ => Composited::Some(number("composited") as u64),
            },
            stopped: Some(stopped),
            peeling: Peeling::Used,
            ..Drawn::default()
        })
    }
}

const ENTRY: Entry = Entry {
    name: "coplanar-depth-peeling",
    source: "Vasilakis and Fudos 2013",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrder,
    memory: Memory::Pixels,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for CoplanarDepthPeelingOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(CoplanarDepthPeeling {
            options: *self,
            color: setup.color,
            depth: setup.depth,
            bound: f64::INFINITY,
        })
    }
}

impl Published for CoplanarDepthPeelingOptions {
    const CHOICES: &'static [Setter<Self>] = &[PEELS.of(|o| &mut o.maximum_number_of_peels)];
}
