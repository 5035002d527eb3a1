//! Lists for marked pixels alone, as another method leaves them: those whose stencil value is not 0.
//!
//! The marked pixels are numbered, and lie side by side in maps of their own, as if they were an image of a few rows. No
//! byte and no draw is spent on the others, and a scattering of pixels is resolved as quickly as a full image. Only the
//! Fill Step draws at the pixels' own places, where the stencil test lets it.
//!
//! The lists are dynamic buffers ([`Manager::Dfb`]) with ppAO and ppDP, in bands of these rows if there are too many.

use super::array_sort::inserts;
use super::bands::{Band, Budget, bands};
use super::options::{ABufferOptions, Fill, Manager, RecordColor};
use super::{ABuffer, paper};
use crate::error::Result;
use crate::gl::{BandParameters, Format, GlMachine, RECORDS, Texels, largest_storage};
use crate::papers::edition;
use crate::scene::Scene;
use crate::steps::{Machine, Map, Variables, gl, run};

/// What was drawn into lists.
pub(in crate::low_level::methods) struct DrawnLists {
    /// All fragments of the lists.
    pub(in crate::low_level::methods) fragments: u64,
    /// The bytes of the lists.
    pub(in crate::low_level::methods) bytes: u64,
}

/// The lists of marked pixels.
pub(in crate::low_level::methods) struct MarkedLists(ABuffer);

const OPTIONS: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    pp_ao: true,
    pp_dp: true,
    fill: Fill::Atomics,
    ..ABufferOptions::DEFAULT
};

impl MarkedLists {
    pub(in crate::low_level::methods) fn new(scene: &Scene) -> Self {
        Self(ABuffer {
            marked: true,
            opaque: scene.meshes.iter().any(|mesh| mesh.opaque),
            ..ABuffer::new(OPTIONS, false)
        })
    }

    /// Whether opaque surfaces may hide fragments.
    pub(in crate::low_level::methods) fn has_opaque(&self) -> bool {
        self.0.opaque
    }

    /// Makes the framebuffer in which lists are filled. The stencil of `marks` has the marks.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(in crate::low_level::methods) fn prepare(
        &mut self,
        machine: &mut GlMachine<'_>,
        scene: &Scene,
        marks: Map,
    ) -> Result<()> {
        self.0.options.color = RecordColor::Fixed;
        if self.0.expect_fixed_fits(machine, scene).is_err() {
            self.0.options.color = RecordColor::Float;
        }
        machine.framebuffer_with(paper::FILL, &[], Some(marks))
    }

    /// Fills the lists, and resolves each over what lies behind it. `most[n]` is a bound of list n's fragments. Where it was
    /// too low, the fill has counted how many there are, and everything is done again.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(in crate::low_level::methods) fn draw(
        &mut self,
        machine: &mut GlMachine<'_>,
        most: Vec<u32>,
    ) -> Result<DrawnLists> {
        let (mut counts, mut bytes) = self.draw_with(machine, &most)?;
        if counts.iter().zip(&most).any(|(count, most)| count > most) {
            (counts, bytes) = self.draw_with(machine, &counts)?;
        }
        let fragments = counts.into_iter().map(u64::from).sum();
        Ok(DrawnLists { fragments, bytes })
    }

    /// The same with room for so many fragments of each list. Returns how many each has, and the bytes of the lists.
    fn draw_with(&mut self, machine: &mut GlMachine<'_>, room: &[u32]) -> Result<(Vec<u32>, u64)> {
        let width = machine.size()[0];
        let options = self.0.options;
        // No list: no room.
        let mut rows_of_room = room.to_vec();
        rows_of_room.resize(room.len().next_multiple_of(width as usize), 0);
        let budget = Budget {
            bytes: u64::MAX,
            fixed: 0,
            records: largest_storage(machine.context(), Texels::Rgba32Ui) / options.record_bytes(),
            preferred_band: u64::MAX,
        };
        let bands = bands(&rows_of_room, width, &options, budget)?;
        let (offsets, bytes) = self.allocate_marked(machine, &rows_of_room, &bands)?;
        let rows = (rows_of_room.len() as u32) / width;
        machine.allocate_rows(paper::COUNTER, Format::R32Ui, rows)?;
        machine.allocate_rows(edition::RESOLVED, Format::Rgba32F, rows)?;
        machine.framebuffer_with(paper::CLEARED, &[paper::COUNTER], None)?;
        machine.framebuffer_with(paper::RESOLVED, &[edition::RESOLVED], None)?;
        // Which place a list has, all shaders know from the width.
        machine.set_parameters(BandParameters {
            rows,
            width,
            ..BandParameters::default()
        })?;
        let behind = match self.has_opaque() {
            true => &edition::OPAQUE_BEHIND,
            false => &edition::BACKGROUND_BEHIND,
        };
        run(behind, &[], Variables::new(), machine)?;
        self.0.layers = bands.iter().map(|band| band.layers).max().unwrap_or(0);
        self.0.inserts = inserts(&options, &rows_of_room, self.0.layers);
        for band in &bands {
            // The Resolve Step of the band before has disabled it.
            machine.perform(&gl::glEnable(gl::STENCIL_TEST))?;
            machine.set_screen(Some([0, band.first_row, width, band.rows]));
            machine.set_parameters(BandParameters {
                first_row: band.first_row,
                rows: band.rows,
                width,
                layers: band.layers,
                capacity: band.records(options.manager, width) as u32,
                before: offsets[(band.first_row * width) as usize],
            })?;
            self.0.draw_band(machine, band, &[])?;
        }
        machine.set_screen(None);
        // A counter begins where its list does in the band, and has counted on, whether or not there was room.
        let counters = machine.read_counts(paper::COUNTER)?;
        let mut counts = vec![0; room.len()];
        for band in &bands {
            let first = (band.first_row * width) as usize;
            let lists = first..room.len().min(first + (band.rows * width) as usize);
            for list in lists {
                let begin = offsets[list].wrapping_sub(offsets[first]);
                counts[list] = counters[list].wrapping_sub(begin);
            }
        }
        Ok((counts, bytes))
    }

    /// Makes the buffers as large as the largest band needs. Returns where each list begins, modulo 2^32, and the buffers'
    /// bytes.
    fn allocate_marked(
        &self,
        machine: &mut GlMachine<'_>,
        room: &[u32],
        bands: &[Band],
    ) -> Result<(Vec<u32>, u64)> {
        let width = machine.size()[0];
        let options = self.0.options;
        let records = bands.iter().map(|band| band.bytes(&options, width));
        let records = records.max().unwrap_or(0);
        machine.allocate_storage(paper::RECORDS, records, Some(Texels::Rgba32Ui))?;
        machine.bind_texels(RECORDS, paper::RECORDS)?;
        let mut next = 0u32;
        let offsets = room.iter().map(|&room| {
            let offset = next;
            // Offsets may wrap around; their differences are right all the same.
            next = next.wrapping_add(room);
            offset
        });
        let offsets: Vec<u32> = offsets.collect();
        let bytes = 4 * offsets.len() as u64;
        machine.allocate_storage(paper::OFFSETS, bytes, None)?;
        machine.write_storage(paper::OFFSETS, bytemuck::cast_slice(&offsets))?;
        // A listing binds these, but dynamic buffers have no use for them.
        machine.allocate_rows(paper::ANCHOR, Format::R32Ui, 1)?;
        for storage in [paper::NEXT, paper::POOL] {
            machine.allocate_storage(storage, 16, None)?;
        }
        Ok((offsets, records + bytes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::{Context, Geometry, Numbers};
    use crate::methods::allocate_maps::allocate_maps;
    use crate::papers::edition::{
        MARKS, NOTHING_OPAQUE, PLACE_RESOLVED, PROOF_DEPTH, RESOURCES, VERIFIED_PAINTER,
    };
    use crate::papers::stage;

    /// Quads that lie the wrong way round: the image, and how many fragments the lists have, given room for so many of each.
    fn drawn(context: &Context, room: u32) -> (Vec<[f32; 4]>, u64) {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
        let mut scene = Scene::load(format!("{folder}/quads.toml")).unwrap();
        scene.size = [48, 36];
        scene.meshes.reverse();
        let mut machine = GlMachine::new(context, scene.size).unwrap();
        let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
        allocate_maps(&mut machine, &[&stage::RESOURCES, &RESOURCES], color, depth).unwrap();
        machine.set_geometry(Geometry::upload(context, &scene, scene.size).unwrap());
        let mut lists = MarkedLists::new(&scene);
        lists.prepare(&mut machine, &scene, PROOF_DEPTH).unwrap();
        machine.begin_frame();
        let words_across = Numbers::words_across(scene.size);
        machine.set_defines(&[("OPAQUE", 0), ("WORDS_ACROSS", words_across)]);
        let bytes = Numbers::bytes_of_marks(scene.size);
        machine.allocate_storage(MARKS, bytes, None).unwrap();
        machine.clear_storage(MARKS).unwrap();
        let none = Variables::new();
        run(
            &VERIFIED_PAINTER,
            &NOTHING_OPAQUE,
            none.clone(),
            &mut machine,
        )
        .unwrap();
        let marks = machine.read_storage(MARKS).unwrap();
        let numbers = Numbers::of(bytemuck::cast_slice(&marks), scene.size);
        assert!(numbers.count() > 200, "{}", numbers.count());
        machine.set_numbers(&numbers).unwrap();
        let room = vec![room; numbers.count() as usize];
        let drawn = lists.draw(&mut machine, room).unwrap();
        run(&PLACE_RESOLVED, &[], none, &mut machine).unwrap();
        (
            machine.read_colors(stage::IMAGE_COLOR).unwrap(),
            drawn.fragments,
        )
    }

    #[test]
    fn lists_without_enough_room_are_drawn_again() {
        let context = Context::headless().unwrap();
        let [enough, little, none] = [64, 1, 0].map(|room| drawn(&context, room));
        assert!(enough.1 > 1000, "{}", enough.1);
        assert!(little == enough);
        // A list without room for anything is drawn again, too.
        assert!(none == enough);
    }
}
