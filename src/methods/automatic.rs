//! The method for those who want the exact image and do not care how: a quick one of the exact methods, for the scene.
//!
//! | the scene has | method | why |
//! | --- | --- | --- |
//! | volumes | `dfb+ppdp` | it casts rays through them, and leaves out no fragment |
//! | slices or other sorted meshes, and transparent meshes that are not | `dfb+ppdp` | what crosses many slices has no order, so most pixels need lists anyway |
//! | other surfaces | `verified-painter` | its one pass of blending is the whole image where the order is proved |
//!
//! Colours in lists have 32 bits. The table is what the choice rests on: frames at 1024 x 768 on llvmpipe with two cores, as
//! ratios of medians to plain blending in the same run of `onionskin bench`. Sorting and uploads of a changed view are in
//! them.
//!
//! | scene | marked pixels | `verified-painter` | `dfb` | `dfb+ppdp` | `dfb+ppao+ppdp` |
//! | --- | --- | --- | --- | --- | --- |
//! | 64 sheets | 0 | 1.18 | 6.55 | 16.0 | 8.21 |
//! | quads | 0 | 1.45 | 6.70 | 7.83 | 6.53 |
//! | teapot over a plane | 552 | 1.78 | 4.40 | 5.09 | 4.30 |
//! | scanned bunny of 100 000 triangles | 62 | 1.32 | 2.93 | 3.19 | 2.97 |
//! | three knots | 3060 | 1.98 | 3.96 | 3.88 | 4.31 |
//! | molecule | 23 217 | 3.14 | 3.54 | 3.93 | 4.32 |
//! | 64 slices and a cone | 122 832 | 22.5 | - | 10.8 | 12.3 |
//!
//! `dfb` alone keeps at most 64 fragments of a pixel. On the slices, hybrid layer peeling takes 6.7 times as long as plain
//! blending, but it puts what is not sorted before what is: of fragments of equal depth, the order is not that of submission.

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
