//! Hybrid layer peeling (Carr et al. 2008, Algorithm 1). Unsorted meshes are peeled, and between two peels the sorted
//! meshes are composited in one go.
//!
//! The scene says which meshes are sorted ([`Mesh::sorted`](crate::scene::Mesh::sorted)). The number of iterations
//! depends only on the other meshes. At the same depth, unsorted surfaces come before sorted ones.
//!
//! Volumes also become sorted meshes: planes across the view, as in figure 1 of Carr et al. A slice stands for a whole
//! slab. If a surface is in a slab, or a ray enters or leaves a volume there, up to half of the slab is on the wrong
//! side. So the error of the image falls with the number of slices.

use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::{AS_PRINTED, LITERAL, Setter, read};
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::loop_guard::{LoopGuard, peeled};
use super::sorting::sorted_meshes_front_to_back;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::papers::carr_2008::hybrid;
use crate::scene::Scene;
use crate::steps::{Reading, run};

/// What can be chosen about hybrid layer peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HybridLayerPeelingOptions {
    /// How the paper's text is read. Loops that go on for too long without its amendments are given up.
    pub reading: Reading,
}

struct HybridLayerPeeling {
    peeled: LoopGuard,
    color: Format,
    depth: Format,
}

impl Algorithm for HybridLayerPeeling {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        DrawOrder::Sorted(sorted_meshes_front_to_back(scene))
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        self.peeled.prepare(machine)?;
        allocate_maps(machine, &hybrid::RESOURCES, self.color, self.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let outcome = run(
            &hybrid::HYBRID,
            &self.peeled.amendments(&hybrid::AMENDMENTS),
            self.peeled.variables(),
            machine,
        )?;
        Ok(peeled(&outcome))
    }
}

const ENTRY: Entry = Entry {
    name: "hybrid-layer-peeling",
    source: "Carr et al. 2008, Algorithm 1",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::UnsortedFirst,
    memory: Memory::PixelsAndTriangles,
    volumes: Volumes::Slices,
    keeps: None,
    needs: &[],
};

impl Technique for HybridLayerPeelingOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(HybridLayerPeeling {
            peeled: LoopGuard::new(self.reading),
            color: setup.color,
            depth: setup.depth,
        })
    }
}

impl Published for HybridLayerPeelingOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
        LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
    ];
}
