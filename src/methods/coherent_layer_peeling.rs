//! Coherent layer peeling (Carr et al. 2008, sections 4 to 6). At each pixel, every iteration composites a whole run of
//! surfaces that were submitted in the right order, and the surface that ends the run.
//!
//! The listings are [`coherent::VARIANT_A`], which counts with the stencil buffer, and [`coherent::VARIANT_B`], which
//! moves depths with float blending. Both composite every surface once and in order, for any order of submission. The
//! order of submission only affects the number of iterations, from 1 for sorted input to half the number of layers for
//! reversed input. So triangles are first sorted roughly ([`TriangleSort`]). Of surfaces at the same depth, the one that is
//! submitted first *after sorting* lies in front.

use super::algorithm::{Algorithm, Composited, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::batches::{Batch, batches, begin_batch};
use super::choice::{AS_PRINTED, IMPROVE, LITERAL, Setter, number, one_of_both, read};
use super::culling::Extents;
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::expect_known::expect_known;
use super::loop_guard::{LoopGuard, peeled};
use super::sorting::{SORT, TriangleSort};
use super::technique::{Published, Technique};
use crate::error::{Error, Result};
use crate::gl::{Format, Geometry, GlMachine};
use crate::papers::carr_2008::coherent::{LOOP_A, LOOP_B, VARIANT_A, VARIANT_B};
use crate::papers::carr_2008::{D_SC, coherent};
use crate::papers::stage;
use crate::scene::{Camera, Scene};
use crate::steps;
use crate::steps::{Amendment, Dialect, Listing, Reading, Variables, run};

/// The two variants of the paper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Variant {
    /// Stencil counting, with six geometry passes per iteration (section 5).
    #[default]
    A,
    /// Float blending, with five geometry passes per iteration (section 6).
    B,
}

/// Options of coherent layer peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CoherentOptions {
    /// Stencil counting or float blending.
    pub variant: Variant,
    /// The sorting of triangles beforehand.
    pub sorting: TriangleSort,
    /// An improvement: equal depths do not break a run ([`coherent::TIE_FRIENDLY`]).
    pub tie_friendly: bool,
    /// An improvement: the loop ends as soon as its first pass finds nothing ([`coherent::STOP_ON_PASS_1`]).
    pub stop_early: bool,
    /// An improvement (section 9, after Wexler et al. 2005): the depth range is cut into so many batches of about equally
    /// many triangles, and each is peeled with the triangles that reach into it. 0 and 1 cut nothing.
    pub batches: u32,
    /// An improvement (section 9): after every iteration, triangles that lie before `D(sc)` wherever they are seen are
    /// culled. It cannot be chosen with batches.
    pub cull: bool,
    /// The camera that triangles are sorted for, if it is not the scene's: a sort that is kept from an earlier frame
    /// (section 4: "updated periodically as the camera moves").
    pub sorted_for: Option<Camera>,
    /// How the paper's listings and prose are read. A loop that goes on for too long without amendments is given up.
    pub reading: Reading,
    /// More amendments to the listings that run, to try the effect of a changed word.
    pub amendments: &'static [Amendment],
}

impl From<Variant> for CoherentOptions {
    fn from(variant: Variant) -> Self {
        Self {
            variant,
            ..Self::default()
        }
    }
}

struct CoherentLayerPeeling {
    options: CoherentOptions,
    peeled: LoopGuard,
    size: [u32; 2],
    color: Format,
    depth: Format,
    batches: Vec<Batch>,
    /// Every triangle, if those that are finished are culled.
    order: Vec<[u32; 2]>,
}

/// In later rounds of a culled loop the range does not begin at the near plane. What lies at `D(sc)` has been composited.
const LATER: [Amendment; 2] = [
    undone(coherent::FIRST_CLOSED),
    undone(coherent::FIRST_CLOSED_B),
];

const fn undone(amendment: Amendment) -> Amendment {
    Amendment {
        printed: amendment.amended,
        amended: amendment.printed,
        ..amendment
    }
}

/// The listings with the amendments applied, so that improvements can be applied on top.
const AMENDED_A: Listing = amended(steps! { run VARIANT_A amended by &coherent::AMENDMENTS; });
const AMENDED_B: Listing = amended(steps! { run VARIANT_B amended by &coherent::AMENDMENTS; });
const FILLED_A: Listing = amended(steps! { run VARIANT_A amended by &coherent::FILLINGS; });
const FILLED_B: Listing = amended(steps! { run VARIANT_B amended by &coherent::FILLINGS; });
const BATCH_A: Listing = amended(steps! { run LOOP_A amended by &coherent::AMENDMENTS; });
const BATCH_B: Listing = amended(steps! { run LOOP_B amended by &coherent::AMENDMENTS; });

const fn amended(steps: &'static [crate::steps::Step]) -> Listing {
    Listing {
        title: "Coherent layer peeling, amended",
        source: "Carr et al. 2008, sections 5 and 6",
        dialect: Dialect::Calls,
        steps,
    }
}

impl CoherentLayerPeeling {
    fn new(options: CoherentOptions, setup: &Setup) -> Self {
        let peeled = LoopGuard::new(options.reading);
        Self {
            options,
            peeled: match options.amendments {
                [] => peeled,
                _ => peeled.guarded(),
            },
            size: setup.size,
            color: setup.color,
            depth: setup.depth,
            batches: Vec::new(),
            order: Vec::new(),
        }
    }

    fn culls(&self) -> bool {
        self.options.cull && self.options.reading == Reading::Amended
    }

    fn amendments(&self) -> Vec<Amendment> {
        let mut amendments = self.options.amendments.to_vec();
        if self.options.tie_friendly {
            amendments.push(coherent::TIE_FRIENDLY);
        }
        if self.options.stop_early {
            amendments.push(coherent::STOP_ON_PASS_1);
            amendments.push(coherent::STOP_ON_SECTION_6);
        }
        amendments
    }

    fn listing(&self) -> Listing {
        match (self.options.variant, self.options.reading) {
            (Variant::A, Reading::Literal) => coherent::VARIANT_A,
            (Variant::B, Reading::Literal) => coherent::VARIANT_B,
            (Variant::A, Reading::AsPrinted) => FILLED_A,
            (Variant::B, Reading::AsPrinted) => FILLED_B,
            (Variant::A, Reading::Amended) => AMENDED_A,
            (Variant::B, Reading::Amended) => AMENDED_B,
        }
    }

    fn submit(&self, machine: &mut GlMachine<'_>, scene: &Scene, order: &[[u32; 2]]) -> Result<()> {
        let geometry = Geometry::upload_in_orders(
            machine.context(),
            scene,
            machine.size(),
            &[order.to_vec()],
        )?;
        machine.set_geometry(geometry);
        Ok(())
    }

    /// Iterates with the triangles that are not finished. Each iteration is a run of the loop of its own.
    fn draw_culled(&self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let listing = self.one_loop();
        let mut amendments = self.amendments();
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
        run(&stage::CLEAR_ACCUMULATION, &[], Variables::new(), machine)?;
        run(
            &coherent::FROM_THE_NEAR_PLANE,
            &[],
            Variables::new(),
            machine,
        )?;
        let opaque = machine.read_depths(stage::OPAQUE_DEPTH)?;
        let extents = Extents::new(scene, machine.size(), &self.order);
        let mut all = Drawn::default();
        let mut composited = 0;
        while all.stopped.is_none() {
            let once = Variables::new().with("iteration_limit", 1.0);
            let outcome = run(&listing, &amendments, once, machine)?;
            all.iterations += 1;
            composited += peeled(&outcome).composited.count();
            all.stopped = outcome.stopped;
            if all.iterations == 1 {
                amendments.extend(LATER);
            }
            let bound = machine.read_depths(D_SC)?;
            let order = extents.unfinished(&bound, &opaque, machine.size()[0]);
            self.submit(machine, scene, &order)?;
        }
        run(&stage::OVER_OPAQUE, &[], Variables::new(), machine)?;
        self.submit(machine, scene, &self.order)?;
        all.composited = Composited::Some(composited);
        Ok(all)
    }

    /// The loop alone, amended.
    fn one_loop(&self) -> Listing {
        match self.options.variant {
            Variant::A => BATCH_A,
            Variant::B => BATCH_B,
        }
    }

    /// Renders batch after batch, front to back. Each batch lies between two depths and has the triangles that reach
    /// between them.
    fn draw_batches(&self, machine: &mut GlMachine<'_>) -> Result<Drawn> {
        let mut amendments = self.amendments();
        amendments.push(coherent::UP_TO_THE_BATCH_END);
        let listing = self.one_loop();
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
        run(&stage::CLEAR_ACCUMULATION, &[], Variables::new(), machine)?;
        let mut all = Drawn::default();
        let mut composited = 0;
        for (number, batch) in self.batches.iter().enumerate() {
            // The first order has every triangle.
            machine.choose_order(number + 1)?;
            begin_batch(machine, batch.begin, batch.end)?;
            let drawn = peeled(&run(
                &listing,
                &amendments,
                self.peeled.variables(),
                machine,
            )?);
            all.iterations += drawn.iterations;
            composited += drawn.composited.count();
            all.stopped = drawn.stopped;
        }
        run(&stage::OVER_OPAQUE, &[], Variables::new(), machine)?;
        machine.choose_order(0)?;
        all.composited = Composited::Some(composited);
        Ok(all)
    }
}

impl Algorithm for CoherentLayerPeeling {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        let order = match self.options.sorted_for {
            None => self.options.sorting.order(scene),
            Some(camera) => self.options.sorting.order(&Scene {
                camera,
                ..scene.clone()
            }),
        };
        if self.culls() {
            self.order.clone_from(&order);
        }
        if self.options.batches < 2 || self.options.reading != Reading::Amended {
            return DrawOrder::Sorted(order);
        }
        let (batches, mut orders) = batches(scene, self.size, &order, self.options.batches);
        self.batches = batches;
        orders.insert(0, order);
        DrawOrder::InTurn(orders)
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        if !self.depth.has_stencil() {
            return Err(Error::option(
                "depth",
                "coherent layer peeling counts in the stencil buffer, and this depth format has none",
                "choose a depth format with a stencil",
            ));
        }
        self.peeled.prepare(machine)?;
        let resources = match self.options.variant {
            Variant::A => coherent::RESOURCES_A,
            // Depths as colors need the image's full float precision (CX17).
            Variant::B => coherent::RESOURCES_B,
        };
        allocate_maps(machine, &resources, self.color, self.depth)?;
        expect_known(machine, &self.listing(), &self.amendments(), &resources)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        if !self.batches.is_empty() {
            return self.draw_batches(machine);
        }
        if self.culls() {
            return self.draw_culled(machine, scene);
        }
        let outcome = run(
            &self.listing(),
            &self.amendments(),
            self.peeled.variables(),
            machine,
        )?;
        Ok(peeled(&outcome))
    }
}

const ENTRY_A: Entry = Entry {
    name: "coherent-layer-peeling-a",
    source: "Carr et al. 2008, section 5",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrderAfterSorting,
    memory: Memory::PixelsAndTriangles,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

const ENTRY_B: Entry = Entry {
    name: "coherent-layer-peeling-b",
    source: "Carr et al. 2008, section 6",
    ..ENTRY_A
};

impl Technique for CoherentOptions {
    fn entry(&self) -> &'static Entry {
        match self.variant {
            Variant::A => &ENTRY_A,
            Variant::B => &ENTRY_B,
        }
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(CoherentLayerPeeling::new(*self, setup))
    }

    fn check(&self) -> Result<()> {
        if self.cull && self.batches > 1 {
            return Err(Error::option(
                "improve",
                "batches and cull both choose which triangles an iteration draws",
                "choose one of the two",
            ));
        }
        let improved = self.tie_friendly || self.stop_early || self.batches > 0 || self.cull;
        one_of_both(self.reading, improved)
    }

    fn needs_window_depth(&self) -> Option<&'static str> {
        (self.batches > 1 || self.cull)
            .then_some("batches and culling compare triangles with window-space depth")
    }
}

fn improve(options: &mut CoherentOptions, improvement: &str) -> Result<()> {
    match improvement.split_once('=') {
        None if improvement == "tie-friendly" => options.tie_friendly = true,
        None if improvement == "early-stop" => options.stop_early = true,
        None if improvement == "cull" => options.cull = true,
        Some(("batches", count)) => {
            options.batches = number(count)?;
            if !(1..=1000).contains(&options.batches) {
                return Err(no_improvement(improvement));
            }
        }
        _ => return Err(no_improvement(improvement)),
    }
    Ok(())
}

fn no_improvement(text: &str) -> Error {
    Error::usage(
        format!("'{text}' is no improvement of variants A and B"),
        "write tie-friendly, early-stop, cull, or batches=N with N from 1 to 1000 (tight-bound is for Algorithm 2)",
    )
}

impl Published for CoherentOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        SORT.of(|o| &mut o.sorting),
        IMPROVE.by(|o, list| list.split(',').try_for_each(|text| improve(o, text))),
        AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
        LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
    ];

    fn variants() -> Vec<Self> {
        [Variant::A, Variant::B].map(Self::from).to_vec()
    }
}
