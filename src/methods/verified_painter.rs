//! The verified painter, this edition's own: triangles are sorted approximately, back to front, and blended over one
//! another in one pass, in which the depth test proves at which pixels the order was right. The other pixels get fragment
//! lists.
//!
//! [`edition`](crate::low_level::papers::edition) has the listing and the proof. A frame has four parts:
//!
//! 1. The CPU sorts the triangles of all transparent meshes together by their centroids ([`view_order`]), and uploads their
//!    indices. This is part of every frame, because every frame may have another view.
//! 2. One pass blends them, and marks in the stencil buffer where their order was wrong.
//! 3. A pass over the screen says which pixels are marked. If none is, that is all.
//! 4. The CPU numbers them, and counts how many triangles reach each ([`touching`]). These triangles are drawn again, in the
//!    order of submission, into lists for the marked pixels alone: dynamic buffers, resolved with ppAO and ppDP (Lindholm et
//!    al. 2015). What comes out is put in its place.
//!
//! Triangles that cross planes, such as slices, are drawn [in pieces](pieces). Others that are much longer along the view than
//! their distance from others have no right order, and then the pixels that they cover are marked.
//!
//! # What was tried
//!
//! At 1024 x 768, on llvmpipe with two cores. Times are of steps in one run.
//!
//! | tried | figures | kept |
//! | --- | --- | --- |
//! | counting the lists' fragments by a draw, as for other lists | the draw took 0.65 of the time of the one that fills the lists of the molecule, 0.81 on the knots | no: the CPU counts |
//! | a second pass for the marked pixels with another key, the nearest corner | it leaves 2127 of the knots' 3060 marked pixels, 16 090 of the molecule's 23 217, 277 of the teapot's 552; and it draws the triangles that the fill draws, and nearly all of these again for what it leaves | no |
//! | a third key, the farthest corner | all three leave 1384, 10 180 and 139 | no |
//! | nearest corners of front faces, farthest ones of back faces | three times as many marked pixels on the molecule and on the knots | no |
//! | 65 536 steps of the sort instead of 1024 | 4 % less marked pixels on the molecule and on the knots | no: neighbours share vertices |
//! | no list where all fragments have one colour, or behind an alpha of 1 | no marked pixel of the bundled scenes is like that | no |
//! | opaque depths in the depth test, and a pixel is marked by `EQUAL` and `(KEEP, DECR, REPLACE)` only after something has passed | frames of the molecule take 0.94 of the time, but hidden fragments that come late mark 1 % more pixels | no, but on GPUs it would leave the early depth test in place |
//!
//! Excludes: multisampling; volumes, unless they are drawn as slices.

mod estimate;
mod pieces;
mod touching;
mod view_order;

use super::a_buffer::MarkedLists;
use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::stats::VerifiedCounts;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{GlMachine, Numbers, PIECES, Texels};
use crate::papers::edition::{
    BEHIND, BOUNDS, FAILED, IN_PIECES, MARKS, NOTHING_OPAQUE, PLACE_RESOLVED, PROOF_DEPTH,
    RESOLVED, RESOURCES, VERIFIED_PAINTER,
};
use crate::scene::Scene;
use crate::steps::{Machine, Variables, run};

use pieces::Pieces;
use view_order::{Sorted, Triangles};

/// The verified painter, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct VerifiedPainter;

/// The method at work.
pub(super) struct Verified {
    setup: Setup,
    triangles: Triangles,
    pieces: Option<Pieces>,
    lists: Option<MarkedLists>,
}

impl Verified {
    pub(super) fn new(setup: &Setup) -> Self {
        Self {
            setup: *setup,
            triangles: Triangles::default(),
            pieces: None,
            lists: None,
        }
    }

    /// The scene's transparent triangles, back to front as well as the CPU can tell.
    pub(super) fn sort(&self, machine: &GlMachine<'_>, scene: &Scene) -> Sorted {
        match &self.pieces {
            None => self.triangles.back_to_front(&scene.camera),
            Some(pieces) => pieces.back_to_front(&self.triangles, &scene.camera, machine.origin()),
        }
    }

    /// The part of the fragments that will be in lists, about, 0 to 1.
    pub(super) fn part_in_disorder(&self, scene: &Scene, sorted: &Sorted, size: [u32; 2]) -> f64 {
        self.triangles.part_in_disorder(sorted, &scene.camera, size)
    }

    /// Lets go of the maps that are of no use to other methods.
    pub(super) fn free(&self, machine: &mut GlMachine<'_>) {
        for map in [PROOF_DEPTH, BEHIND, RESOLVED] {
            machine.free(map);
        }
    }

    /// Has all triangles drawn in the order of submission.
    pub(super) fn submit(&self, machine: &mut GlMachine<'_>) -> Result<()> {
        machine.submit_triangles(&self.triangles.submitted)
    }

    /// [`Algorithm::draw`] with triangles that are sorted.
    pub(super) fn draw_sorted(
        &mut self,
        machine: &mut GlMachine<'_>,
        scene: &Scene,
        sorted: &Sorted,
    ) -> Result<Drawn> {
        let Some(lists) = &mut self.lists else {
            return Ok(Drawn::default());
        };
        machine.set_defines(&[
            ("OPAQUE", u32::from(lists.has_opaque())),
            ("WORDS_ACROSS", Numbers::words_across(machine.size())),
        ]);
        machine.submit_triangles(&sorted.triangles)?;
        machine.clear_storage(MARKS)?;
        let mut amendments = Vec::new();
        if !lists.has_opaque() {
            amendments.extend(NOTHING_OPAQUE);
        }
        if let Some(bounds) = &sorted.bounds {
            let bytes = bytemuck::cast_slice(bounds);
            machine.allocate_storage(BOUNDS, size_of_val(bytes) as u64, Some(Texels::Rgba32F))?;
            machine.write_storage(BOUNDS, bytes)?;
            machine.bind_texels(PIECES, BOUNDS)?;
            amendments.extend(IN_PIECES);
        }
        run(&VERIFIED_PAINTER, &amendments, Variables::new(), machine)?;
        let mut counts = VerifiedCounts {
            marked_pixels: machine.samples(FAILED)?,
            ..VerifiedCounts::default()
        };
        if counts.marked_pixels > 0 {
            let size = machine.size();
            let marks = machine.read_storage(MARKS)?;
            let numbers = Numbers::of(bytemuck::cast_slice(&marks), size);
            machine.set_numbers(&numbers)?;
            let touching = self.triangles.touching(&scene.camera, size, &numbers);
            counts.list_triangles = touching.triangles.len() as u64;
            machine.submit_triangles(&touching.triangles)?;
            let drawn = lists.draw(machine, touching.counts)?;
            counts.list_fragments = drawn.fragments;
            counts.list_bytes = drawn.bytes;
            run(&PLACE_RESOLVED, &[], Variables::new(), machine)?;
        }
        Ok(Drawn {
            iterations: 1,
            verified: Some(counts),
            ..Drawn::default()
        })
    }
}

impl Algorithm for Verified {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        self.triangles = Triangles::of(scene);
        self.pieces = Pieces::of(scene, &self.triangles);
        DrawOrder::Own
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        let mut lists = MarkedLists::new(scene);
        machine.allocate_storage(MARKS, Numbers::bytes_of_marks(machine.size()), None)?;
        allocate_maps(machine, &[&RESOURCES], self.setup.color, self.setup.depth)?;
        lists.prepare(machine, scene, PROOF_DEPTH)?;
        self.lists = Some(lists);
        Ok(())
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let sorted = self.sort(machine, scene);
        self.draw_sorted(machine, scene, &sorted)
    }

    /// What is counted next is all triangles.
    fn account(&mut self, machine: &mut GlMachine<'_>, _: &mut Drawn) -> Result<()> {
        self.submit(machine)
    }
}

const ENTRY: Entry = Entry {
    name: "verified-painter",
    source: "this edition",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrder,
    memory: Memory::PixelsAndTriangles,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for VerifiedPainter {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(Verified::new(setup))
    }
}

impl Published for VerifiedPainter {}
