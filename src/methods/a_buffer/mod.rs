//! A-buffers (Lindholm et al. 2015). Every fragment is kept, in a list for each pixel. Then each list is sorted in a
//! Local Array and composited.
//!
//! There are three steps (figure 3): clear, fill, resolve. Lists are in global memory, which is managed in one of three
//! ways ([`Manager`]). Local Arrays are private memory of a shader. They are static, or managed by the paper's two
//! components, ppAO and ppDP. Fragments of equal depth are composited in the order of submission, with every manager
//! and every fill: a record's id is its triangle's place in that order.
//!
//! Some fragments are not in the image. A static array, and ppAO alone, leave out fragments after the first N of a
//! list, whose order [`Keep`] explains, or with [`Keep::Nearest`] fragments behind the N nearest. Early ray termination
//! leaves out fragments behind the point where the ray ended. As printed, ppDP leaves out ties across its subpasses.
//! All of these fragments are counted.
//!
//! Volumes (section 6.1) enter the lists as the boxes around them, and rays are cast between the fragments. If a static
//! array drops a box's fragment, it is unknown where the ray enters or leaves the volume. The ray is then taken to
//! begin or to stay inside, and the pixel counts as truncated.
//!
//! # What was tried
//!
//! On llvmpipe with two cores, 64 sheets and random triangles at 1024 x 768, with ppAO and ppDP. Figures are ratios of a step's
//! time to that of plain blending in the same run, over three runs on a busy machine.
//!
//! | tried | figures | kept |
//! | --- | --- | --- |
//! | texels of a buffer image (`imageStore`) instead of a storage buffer's words in the Fill Step, Mesa 22.3 | sheets 4.2 to 5.2 instead of 3.5 to 3.7, triangles 3.1 to 3.7 instead of 2.6 to 3.1 | no |
//! | the same, Mesa 25.0 | sheets 7.2 to 15 instead of 4.0 to 5.8, triangles 4.0 to 5.2 instead of 3.6 to 3.9 | no |
//! | ppAO's segments in the stencil buffer, so that empty pixels and those of other segments are passed over | the Resolve Step of triangles 5.2 to 7.8 instead of 5.3 to 8.3, of sheets 5.0 to 5.5 instead of 3.8 to 5.7; and 1.5 to 2.1 or 0.2 to 0.8 more for the stencil | no |
//! | colours of 24 bits ([`RecordColor::Fixed`]) instead of 32, and no ids, for the verified painter's marked pixels | whole frames of 16 layers, 94 % of them in disorder: 6.7 to 8.0 instead of 7.7 to 9.9; of random triangles 4.9 to 5.4 instead of 7.3 to 9.9 | yes |
//!
//! Per fragment, random order takes 5.7 times as long with 256 layers as with 16 by `dfb+ppao+ppdp`, and 4.4 times by
//! `dfb+ppdp` (sheets in random order at 256 x 192): ppDP reads a list once for each array that it fills.
//!
//! Excludes: multisampling.

mod array_sort;
mod bands;
mod choices;
mod counting;
mod defines;
mod entries;
mod fixed_color;
mod lists;
mod loops;
mod marked;
mod options;

pub(super) use counting::expect_stencil;
pub(super) use marked::MarkedLists;

use bands::{Band, Budget, bands, fixed, preferred};
pub use options::{ABufferOptions, ArraySort, Fill, Keep, LARGEST_NETWORK, Manager, RecordColor};

use array_sort::inserts;

use super::algorithm::{Algorithm, Composited, Drawn};
use super::expect_known::expect_known;
use super::proxies::proxies;
use super::stats::ABufferCounts;
use super::technique::Technique;
use crate::error::{Error, Result};
use crate::gl::{Format, GlMachine, Texels, largest_storage};
use crate::papers::lindholm_2015 as paper;
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Amendment, Listing, Machine, Reading, Reason, Resources, Variables, run};

struct ABuffer {
    options: ABufferOptions,
    counts: ABufferCounts,
    /// Whether the Resolve Step records the cost of each pixel.
    counts_costs: bool,
    /// VOLUMES and POINTS, for the shaders.
    volumes: [(&'static str, u32); 2],
    /// Every pixel's complexity, row by row from the bottom.
    complexity: Vec<u32>,
    /// The deepest pixel's.
    layers: u32,
    /// Whether Local Arrays are sorted by insertion.
    inserts: bool,
    /// Whether only marked pixels have lists: see [`MarkedLists`].
    marked: bool,
    /// Whether the scene has opaque surfaces, which the shaders ask about where only marked pixels have lists.
    opaque: bool,
}

impl ABuffer {
    fn new(options: ABufferOptions, counts_costs: bool) -> Self {
        Self {
            options,
            counts: ABufferCounts::default(),
            counts_costs,
            volumes: [("VOLUMES", 0), ("POINTS", 0)],
            complexity: Vec::new(),
            layers: 0,
            inserts: true,
            marked: false,
            opaque: false,
        }
    }

    fn ordered(&self, machine: &GlMachine<'_>) -> bool {
        // A marked pixel's counter is not at the pixel, so no framebuffer has it.
        !self.marked
            && self.options.fill != Fill::Atomics
            && machine
                .context()
                .driver()
                .has("GL_EXT_shader_framebuffer_fetch")
    }

    /// Whether lists have their fragments in the order of submission. Atomics leave them so on a driver that runs a pixel's
    /// shaders in this order.
    fn in_order(&self, machine: &GlMachine<'_>) -> bool {
        let quirks = machine.context().driver().quirks();
        self.ordered(machine) || self.marked && quirks.runs_in_order
    }

    /// Checks that records may do without ids and without colours over 1.
    fn expect_fixed_fits(&self, machine: &GlMachine<'_>, scene: &Scene) -> Result<()> {
        if self.options.color != RecordColor::Fixed
            || self.in_order(machine) && scene.volumes.is_empty() && fixed_color::holds(scene)
        {
            return Ok(());
        }
        Err(Error::option(
            "record-color",
            "records of fixed-point colours have no ids, and hold nothing but 0 to 1: they are for scenes without volumes, \
             whose colours are from 0 to 1, and for lists that are filled in order",
            "choose float",
        ))
    }

    fn budget(&self, machine: &GlMachine<'_>, scene: &Scene) -> Budget {
        let record = self.options.color.record_bytes();
        let largest = largest_storage(machine.context(), Texels::Rgba32Ui) / record;
        let links = largest_storage(machine.context(), Texels::R32Ui) / 4;
        let quirks = machine.context().driver().quirks();
        let triangles = scene.triangle_count() as u64;
        let [width, height] = machine.size();
        let bytes = self.options.budget;
        Budget {
            bytes: bytes.unwrap_or(u64::MAX),
            fixed: fixed(&self.options, u64::from(width) * u64::from(height)),
            records: largest.min(links),
            preferred_band: match (bytes, self.options.fixed_layers) {
                (Some(bytes), _) => bytes,
                // A band more would be a geometry pass more.
                (None, Some(_)) => u64::MAX,
                (None, None) => preferred(quirks, triangles, self.options.record_bytes()),
            },
        }
    }
}

impl Algorithm for ABuffer {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        self.options.check()?;
        self.expect_known(machine)?;
        if self.options.is_printed() && self.options.pp_ao {
            expect_stencil(machine)?;
        }
        self.expect_fixed_fits(machine, scene)?;
        let quirks = machine.context().driver().quirks();
        loops::expect_samples_fit(quirks, &scene.volumes)?;
        self.volumes = machine.upload_volumes(scene)?;
        if self.options.fill == Fill::Ordered && !self.ordered(machine) {
            return Err(Error::Driver {
                what: "this driver has no GL_EXT_shader_framebuffer_fetch".into(),
                remedy: "fill with atomics".into(),
            });
        }
        if self.options.fill == Fill::Automatic {
            self.options.fill = match self.ordered(machine) {
                true => Fill::Ordered,
                false => Fill::Atomics,
            };
        }
        machine.allocate(stage::COMPLEXITY, Format::R32F)?;
        machine.allocate(paper::COUNTER, Format::R32Ui)?;
        machine.allocate(paper::ANCHOR, Format::R32Ui)?;
        let depth = stage::OPAQUE_DEPTH;
        // An attachment costs time even if it is not written.
        let [cleared, inouts]: [&[_]; 2] = match (self.ordered(machine), self.options.manager) {
            (true, _) => [&[paper::COUNTER], &[paper::COUNTER]],
            (false, Manager::Ffb | Manager::Dfb) => [&[paper::COUNTER], &[]],
            (false, Manager::Ppll) => [&[paper::COUNTER, paper::ANCHOR], &[]],
        };
        machine.framebuffer_with(paper::CLEARED, cleared, Some(depth))?;
        machine.framebuffer_with(paper::FILL, inouts, Some(depth))?;
        if !self.counts_costs {
            return machine.framebuffer_with(paper::RESOLVED, &[stage::IMAGE_COLOR], Some(depth));
        }
        machine.allocate(paper::COST, Format::Rgba32Ui)?;
        machine.framebuffer_with(
            paper::RESOLVED,
            &[stage::IMAGE_COLOR, paper::COST],
            Some(depth),
        )
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
        let amendments = [self.options.amendments, proxies(scene)].concat();
        if machine.has_inverse_w() {
            // The Fill Step's shaders look it up.
            run(&paper::OPAQUE_ENDS_RAYS, &[], Variables::new(), machine)?;
        }
        self.counts = ABufferCounts::default();
        self.complexity = self.count(machine, &amendments)?;
        let width = machine.size()[0];
        let budget = self.budget(machine, scene);
        let bands = bands(&self.complexity, width, &self.options, budget)?;
        if !scene.volumes.is_empty() {
            run(&paper::OPAQUE_ENDS_RAYS, &[], Variables::new(), machine)?;
            machine.bind_volumes()?;
        }
        if self.counts_costs {
            run(&paper::CLEAR_COST, &[], Variables::new(), machine)?;
        }
        self.layers = bands.iter().map(|band| band.layers).max().unwrap_or(0);
        self.inserts = inserts(&self.options, &self.complexity, self.layers);
        self.counts.bands = bands.len() as u32;
        if self.layers > 0 {
            let bytes = bands.iter().map(|band| band.bytes(&self.options, width));
            self.counts.list_bytes = bytes.max().unwrap_or(0) + budget.fixed;
            self.allocate_lists(machine, &bands)?;
        }
        let mut fragments_before = 0;
        for band in bands.iter().filter(|band| band.fragments > 0) {
            self.begin_band(machine, band, fragments_before)?;
            self.draw_band(machine, band, &amendments)?;
            fragments_before += band.fragments;
        }
        machine.set_band(None);
        Ok(Drawn {
            iterations: 1,
            ..Drawn::default()
        })
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        if !self.counts_costs {
            drawn.composited = Composited::Unknown;
            return Ok(());
        }
        if self.options.fixed_layers.is_some() {
            self.complexity = machine.read_counts(paper::COUNTER)?;
        }
        let why_truncated = self.why_truncated();
        let mut composited = 0;
        // Each subpass resolves one fragment at least, unless it waits for one that is lost.
        let mut endless = false;
        let counts = &mut self.counts;
        let costs = machine.read_integers(paper::COST)?;
        for (&[read, seen, subpasses, slots], &complexity) in costs.iter().zip(&self.complexity) {
            counts.records_read += u64::from(read);
            counts.subpasses += u64::from(subpasses);
            counts.most_subpasses = counts.most_subpasses.max(subpasses);
            counts.slots_reserved += u64::from(slots >> 16);
            counts.slots_used += u64::from(slots & 0xFFFF);
            counts.truncated_pixels += u64::from(seen < complexity);
            composited += u64::from(seen);
            endless |= subpasses > complexity;
        }
        drawn.composited = Composited::Some(composited);
        if counts.truncated_pixels > 0 {
            drawn.stopped = Some(match endless {
                true => Reason::NoEnd,
                false => why_truncated,
            });
        }
        drawn.a_buffer = Some(*counts);
        Ok(())
    }
}

impl ABuffer {
    fn why_truncated(&self) -> Reason {
        let options = &self.options;
        match options.fixed_layers {
            _ if options.termination > 0.0 => Reason::EarlyTermination,
            _ if options.most_subpasses.is_some() => Reason::PeelLimit,
            Some(layers) if options.pp_dp || layers < options.array => Reason::BufferFull,
            _ => Reason::ArrayFull,
        }
    }

    /// The Clear Step and the Fill Step.
    fn filling(&self) -> &'static Listing {
        match (self.options.pp_ao, self.options.reading) {
            (true, Reading::Literal) => &paper::FILL_FOR_PP_AO,
            (true, Reading::AsPrinted) => &paper::CLEAR_AND_COUNTING_FILL,
            (true, Reading::Amended) | (false, _) => &paper::CLEAR_AND_FILL,
        }
    }

    /// Checks that the caller's amendments name only what there is.
    fn expect_known(&self, machine: &GlMachine<'_>) -> Result<()> {
        const SIZES: Resources = Resources {
            variables: &["N", "num_segments"],
            ..Resources::NONE
        };
        let amendments = self.options.amendments;
        let resolving = match self.options.pp_ao {
            true => &paper::PP_AO,
            false => &paper::RESOLVE,
        };
        let lists = [&stage::COUNTING, &paper::FILLING, &paper::RESOLVING, &SIZES];
        expect_known(machine, self.filling(), amendments, &lists)?;
        expect_known(machine, resolving, amendments, &lists)
    }

    /// The caller's own `amendments`, and what amends the Fill Step if there are volumes.
    fn draw_band(
        &mut self,
        machine: &mut GlMachine<'_>,
        band: &Band,
        amendments: &[Amendment],
    ) -> Result<()> {
        let options = &self.options;
        let quirks = machine.context().driver().quirks();
        let array = options.array;
        let insertion = self.inserts
            && (!options.pp_dp || loops::insertion_fits(quirks, band.layers))
            && (options.keep == Keep::First
                || loops::keeping_by_insertion_fits(quirks, array, band.layers));
        if options.keep == Keep::Nearest {
            loops::expect_keeping_fits(quirks, array, band.layers)?;
        }
        machine.set_defines(&self.defines(machine, insertion));
        let mut fill = amendments.to_vec();
        if options.has_offsets() {
            fill.push(paper::BEGIN_AT_OFFSETS);
        }
        if self.ordered(machine) {
            fill.push(paper::ORDERED);
        }
        run(self.filling(), &fill, Variables::new(), machine)?;
        self.resolve(machine, band.layers)
    }

    /// Resolves a band whose deepest pixel has `layers` fragments.
    fn resolve(&mut self, machine: &mut GlMachine<'_>, layers: u32) -> Result<()> {
        let options = &self.options;
        let quirks = machine.context().driver().quirks();
        let mut peel = options.peel;
        if options.pp_dp {
            peel = loops::peel_that_fits(quirks, peel, layers)?;
            if options.pp_ao {
                // The last segment peels with the largest array there is.
                loops::peel_that_fits(quirks, options.array, layers)?;
                loops::expect_inserting_fits(quirks, options.array, layers)?;
            }
        }
        let variables = Variables::new();
        if !options.pp_ao {
            let size = if options.pp_dp { peel } else { options.array };
            run(
                &paper::RESOLVE,
                &[],
                variables.with("N", f64::from(size)),
                machine,
            )?;
            return Ok(());
        }
        let masking = [paper::BY_COUNTER, paper::NO_STENCIL, paper::MARKED];
        let amendments = [options.amendments, &options.reading.of(&masking)].concat();
        let segments = self.segments_for(layers);
        run(
            &paper::PP_AO,
            &amendments,
            variables.with("num_segments", segments as f64),
            machine,
        )?;
        self.counts.resolved += machine.samples(paper::COVERED)?;
        Ok(())
    }

    /// The number of ppAO's segments that have a pixel, if the deepest pixel has `layers` fragments. As printed,
    /// segments are not told apart, and all of them are drawn.
    fn segments_for(&self, layers: u32) -> usize {
        let all = self.options.segments().count();
        let takes_the_deepest = self.options.segments().position(|size| layers <= size);
        match takes_the_deepest {
            Some(last) if !self.options.is_printed() => last + 1,
            _ => all,
        }
    }
}

/// The smallest format of colours in which a scene's surfaces stay exact: for A-buffers whose fill is automatic.
pub(super) fn exact_color(machine: &GlMachine<'_>, scene: &Scene) -> RecordColor {
    let lists = ABuffer::new(EXACT, false);
    match lists.expect_fixed_fits(machine, scene) {
        Ok(()) => RecordColor::Fixed,
        Err(_) => RecordColor::Float,
    }
}

/// Lets go of the maps of A-buffers that are of no use to other methods.
pub(super) fn free_maps_of_lists(machine: &mut GlMachine<'_>) {
    for map in [stage::COMPLEXITY, paper::COST] {
        machine.free(map);
    }
}

const EXACT: ABufferOptions = ABufferOptions {
    color: RecordColor::Fixed,
    ..ABufferOptions::DEFAULT
};

#[cfg(test)]
mod tests {
    use super::super::technique::Published;
    use super::*;

    #[test]
    fn a_method_s_name_begins_with_its_manager_s_word() {
        for method in <ABufferOptions as Published>::variants() {
            let (manager, name) = (method.manager, method.entry().name);
            assert_eq!(
                name.split('+').next().unwrap().parse::<Manager>().unwrap(),
                manager
            );
        }
    }

    #[test]
    fn segments_that_no_pixel_needs_are_left_out_but_not_as_printed() {
        let segments = |reading, layers| {
            let options = ABufferOptions {
                pp_ao: true,
                reading,
                ..ABufferOptions::DEFAULT
            };
            ABuffer::new(options, true).segments_for(layers)
        };
        let amended =
            [0, 8, 9, 16, 33, 64, 65, 1000].map(|layers| segments(Reading::Amended, layers));
        assert_eq!(amended, [1, 1, 2, 2, 4, 4, 4, 4]);
        assert_eq!(segments(Reading::AsPrinted, 8), 4);
    }
}
