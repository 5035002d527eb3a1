//! The method for those who want the exact image and do not care how: a quick one of the exact methods, for the scene.
//!
//! | the scene has | method | why |
//! | --- | --- | --- |
//! | volumes | `dfb+ppdp` | it casts rays through them, and leaves out no fragment |
//! | surfaces | `verified-painter` | its one pass of blending is the whole image where the order is proved |
//! | surfaces, and most fragments in pixels out of order | `dfb+ppao+ppdp` | lists for all pixels are quicker than a proof that fails |
//!
//! How much of a frame is out of order is estimated when its triangles are sorted, at a thousand points of the image. On the
//! bench's sweep of disorder, the verified painter takes about 1.6 + 6.3 p times as long as plain blending if the part p of
//! the fragments is out of order, and lists for all pixels take about 5.1 times as long: they cross at p = 0.55.
//!
//! Colours in lists have 24 bits ([`RecordColor::Fixed`]) where that is exact, and otherwise 32. The table is what the choice
//! rests on: frames at 1024 x 768 on llvmpipe with two cores, as ratios of medians to plain blending in the same run of
//! `onionskin bench`. Sorting and uploads of a changed view are in them.
//!
//! | scene | marked pixels | `verified-painter` | `auto` | `dfb` | `dfb+ppdp` | `dfb+ppao+ppdp` |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | 64 sheets | 0 | 1.09 | 1.31 | 9.41 | 27.1 | 13.8 |
//! | quads | 0 | 1.85 | 2.08 | 8.51 | 9.85 | 6.23 |
//! | teapot over a plane | 552 | 2.16 | 2.49 | 5.34 | 6.38 | 6.43 |
//! | three knots | 3060 | 1.92 | 1.99 | 3.10 | 3.54 | 3.48 |
//! | molecule | 23 217 | 3.20 | 3.15 | 4.11 | 5.15 | 4.62 |
//! | random triangles | 82 191 | 7.22 | 7.06 | 8.90 | 11.3 | 10.6 |
//! | 64 slices and a cone | 8 | 2.31 | 2.45 | - | - | 12.2 |
//! | 16 layers, 26 % of them out of order | 51 456 | 3.58 | 3.83 | 4.90 | 5.67 | 5.76 |
//! | 16 layers, 53 % | 103 840 | 5.88 | 4.72 | 4.51 | 5.66 | 5.59 |
//! | 16 layers, 94 % | 184 665 | 7.63 | 5.72 | 5.33 | 6.78 | 5.82 |
//!
//! `dfb` and `dfb+ppao+ppdp` are measured as they are by default, with colours of 16 bits, and `dfb` keeps at most 64 fragments
//! of a pixel. On the slices, hybrid layer peeling takes 7.2 times as long as plain blending, in a run in which `auto` takes 2.2.
//!
//! The machine was busy, so neighbours in a row may differ by a tenth without a reason. With less to do, and in runs of these
//! two alone, `verified-painter` and `auto` took 1.22 and 1.22 on the sheets, 1.50 and 1.45 on the quads, 1.40 and 1.31 on the
//! teapot, 1.73 and 1.69 on the knots.
//!
//! All of this was measured while the verified painter counted its lists by a draw. Since the CPU counts them, an idle machine
//! took 1.08 and 1.09 on the sheets, 1.46 and 1.52 on the quads, 1.63 and 1.64 on the teapot, 1.57 and 1.67 on the knots, 2.51
//! and 2.73 on the molecule, 2.20 and 2.29 on the slices. What `auto` takes more is the estimate.

use super::a_buffer::{ABufferOptions, Manager, RecordColor, exact_color, free_maps_of_lists};
use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::entry::{EXACT_BY_RAYS, Entry, Memory, Ties, Volumes};
use super::stats::Chosen;
use super::technique::{Published, Technique};
use super::verified_painter::{Verified, VerifiedPainter};
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

/// The same for surfaces alone, most of which are out of order.
const LISTS_OF_SURFACES: ABufferOptions = ABufferOptions {
    pp_ao: true,
    ..LISTS
};

/// If a larger part of the fragments is in pixels whose order would not be proved, lists for all of them are quicker.
const MOST_IN_DISORDER: f64 = 0.5;

/// The methods among which is chosen.
enum Methods {
    /// For scenes with volumes.
    Rays(Box<dyn Algorithm>),
    /// For surfaces.
    Surfaces {
        verified: Box<Verified>,
        /// Made when they are first needed.
        lists: Option<Box<dyn Algorithm>>,
        /// Which of them has its maps.
        prepared: Option<Surfaces>,
    },
}

/// How a frame of surfaces is drawn.
#[derive(Clone, Copy, PartialEq)]
enum Surfaces {
    Verified,
    Lists,
}

struct AutomaticImage {
    setup: Setup,
    methods: Option<Methods>,
}

impl AutomaticImage {
    fn of(&mut self, scene: &Scene) -> &mut Methods {
        let setup = &self.setup;
        self.methods
            .get_or_insert_with(|| match scene.volumes.is_empty() {
                false => Methods::Rays(LISTS.algorithm(setup)),
                true => Methods::Surfaces {
                    verified: Box::new(Verified::new(setup)),
                    lists: None,
                    prepared: None,
                },
            })
    }
}

impl Algorithm for AutomaticImage {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        match self.of(scene) {
            Methods::Rays(rays) => rays.order(scene),
            Methods::Surfaces { verified, .. } => verified.order(scene),
        }
    }

    /// What surfaces need is known when they are sorted.
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        match self.of(scene) {
            Methods::Rays(rays) => rays.prepare(machine, scene),
            Methods::Surfaces { .. } => Ok(()),
        }
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let setup = self.setup;
        let (drawn, method, why) = match self.of(scene) {
            Methods::Rays(rays) => (
                rays.draw(machine, scene)?,
                LISTS.entry().name,
                "it casts rays through volumes, and leaves out no fragment",
            ),
            Methods::Surfaces {
                verified,
                lists,
                prepared,
            } => {
                let sorted = verified.sort(machine, scene);
                let part = verified.part_in_disorder(scene, &sorted, machine.size());
                let surfaces = match part > MOST_IN_DISORDER {
                    true => Surfaces::Lists,
                    false => Surfaces::Verified,
                };
                let is_prepared = prepared.replace(surfaces) == Some(surfaces);
                match surfaces {
                    Surfaces::Lists => {
                        let lists = lists.get_or_insert_with(|| {
                            let color = exact_color(machine, scene);
                            let options = ABufferOptions {
                                color,
                                ..LISTS_OF_SURFACES
                            };
                            options.algorithm(&setup)
                        });
                        if !is_prepared {
                            verified.free(machine);
                            lists.prepare(machine, scene)?;
                        }
                        verified.submit(machine)?;
                        (
                            lists.draw(machine, scene)?,
                            LISTS_OF_SURFACES.entry().name,
                            "most pixels would be out of order",
                        )
                    }
                    Surfaces::Verified => {
                        if !is_prepared {
                            free_maps_of_lists(machine);
                            verified.prepare(machine, scene)?;
                        }
                        (
                            verified.draw_sorted(machine, scene, &sorted)?,
                            VerifiedPainter.entry().name,
                            "one pass of blending is the whole image where its order is proved",
                        )
                    }
                }
            }
        };
        Ok(Drawn {
            chosen: Some(Chosen { method, why }),
            ..drawn
        })
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        match &mut self.methods {
            Some(Methods::Rays(rays)) => rays.account(machine, drawn),
            Some(Methods::Surfaces {
                verified,
                lists,
                prepared,
            }) => match (prepared, lists) {
                (Some(Surfaces::Lists), Some(lists)) => lists.account(machine, drawn),
                _ => verified.account(machine, drawn),
            },
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
            methods: None,
        })
    }
}

impl Published for Automatic {}
