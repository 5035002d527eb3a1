//! The method for those who want the exact image and do not care how: a quick one of the exact methods, for the scene.
//!
//! | the scene has | method | why |
//! | --- | --- | --- |
//! | volumes | `dfb+ppdp` | it casts rays through them, and leaves out no fragment |
//! | slices or other sorted meshes, and transparent meshes that are not | `dfb+ppdp` | what crosses many slices has no order, so most pixels need lists anyway |
//! | other surfaces | `verified-painter` | its one pass of blending is the whole image where the order is proved |
//!
//! Colours in lists have 32 bits. `onionskin bench` measures the choice. Of the methods that are exact in every
//! pixel, with the order of submission between equal depths, it was the quickest of those measured on the bundled scenes of
//! surfaces. `dfb` alone is a little quicker on the molecule, as long as no pixel has more than 64 fragments; hybrid layer
//! peeling is quicker on slices, but puts what is not sorted before what is.

use super::a_buffer::{ABufferOptions, Manager, RecordColor};
use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::entry::{EXACT_BY_RAYS, Entry, Memory, Ties, Volumes};
use super::stats::Chosen;
use super::technique::{Published, Technique};
use super::verified_painter::VerifiedPainter;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::scene::Scene;

/// A quick exact method for the scene, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Automatic;

/// The lists: every fragment in them, however many a pixel has, with colours of 32 bits.
const LISTS: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    pp_dp: true,
    color: RecordColor::Float,
    ..ABufferOptions::DEFAULT
};

impl Automatic {
    /// The method that is taken for a scene, and the reason as the end of a sentence.
    fn choose(scene: &Scene) -> (&'static dyn Technique, &'static str) {
        let has = |sorted| {
            let mut transparent = scene.meshes.iter().filter(|mesh| !mesh.opaque);
            transparent.any(|mesh| mesh.sorted == sorted)
        };
        if !scene.volumes.is_empty() {
            (
                &LISTS,
                "it casts rays through volumes, and leaves out no fragment",
            )
        } else if has(true) && has(false) {
            (&LISTS, "what crosses slices has no order")
        } else {
            (
                &VerifiedPainter,
                "one pass of blending is the whole image where its order is proved",
            )
        }
    }
}

/// The algorithm of the method that is chosen once the scene is known.
struct AutomaticImage {
    setup: Setup,
    chosen: Option<(Chosen, Box<dyn Algorithm>)>,
}

impl AutomaticImage {
    fn of(&mut self, scene: &Scene) -> &mut (Chosen, Box<dyn Algorithm>) {
        let setup = &self.setup;
        self.chosen.get_or_insert_with(|| {
            let (technique, why) = Automatic::choose(scene);
            let method = technique.entry().name;
            (Chosen { method, why }, technique.algorithm(setup))
        })
    }
}

impl Algorithm for AutomaticImage {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        self.of(scene).1.order(scene)
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        self.of(scene).1.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let (chosen, algorithm) = self.of(scene);
        let drawn = algorithm.draw(machine, scene)?;
        Ok(Drawn {
            chosen: Some(*chosen),
            ..drawn
        })
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        match &mut self.chosen {
            Some((_, algorithm)) => algorithm.account(machine, drawn),
            None => Ok(()),
        }
    }
}

const ENTRY: Entry = Entry {
    name: "auto",
    source: "this edition",
    exact: true,
    exactness: EXACT_BY_RAYS,
    ties: Ties::InOrder,
    memory: Memory::PixelsAndFragments,
    volumes: Volumes::Rays,
    keeps: None,
    needs: &[],
};

impl Technique for Automatic {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(AutomaticImage {
            setup: *setup,
            chosen: None,
        })
    }
}

impl Published for Automatic {}
