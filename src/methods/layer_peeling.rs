//! Layer peeling as Carr et al. (2008) count it, with two geometry passes per iteration: one finds the next depth, and
//! one composites the fragments at that depth.
//!
//! Everitt's depth peeling draws once per layer, because it composites the fragment that its depth test has kept. Layer
//! peeling draws twice, and composites *every* fragment at the depth that was found, so ties stay in the order of
//! submission.

use super::algorithm::{Algorithm, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::{AS_PRINTED, LITERAL, Setter, read};
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::loop_guard::{LoopGuard, peeled};
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::papers::carr_2008::hybrid;
use crate::scene::Scene;
use crate::steps::{Reading, run};

/// What can be chosen about layer peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LayerPeelingOptions {
    /// How the paper's text is read. Loops that go on for too long without its amendments are given up.
    pub reading: Reading,
}

struct LayerPeeling {
    peeled: LoopGuard,
    color: Format,
    depth: Format,
}

impl Algorithm for LayerPeeling {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        self.peeled.prepare(machine)?;
        allocate_maps(machine, &hybrid::RESOURCES, self.color, self.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let outcome = run(
            &hybrid::LAYER_PEELING,
            &self.peeled.amendments(&hybrid::AMENDMENTS),
            self.peeled.variables(),
            machine,
        )?;
        Ok(peeled(&outcome))
    }
}

const ENTRY: Entry = Entry {
    name: "layer-peeling",
    source: "Carr et al. 2008, sections 1 and 8",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrder,
    memory: Memory::Pixels,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for LayerPeelingOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(LayerPeeling {
            peeled: LoopGuard::new(self.reading),
            color: setup.color,
            depth: setup.depth,
        })
    }
}

impl Published for LayerPeelingOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
        LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
    ];
}
