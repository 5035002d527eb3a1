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

    /// Numbers lists as if all were in one band, for passes before the lists are made.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(in crate::low_level::methods) fn number(machine: &mut GlMachine<'_>) -> Result<()> {
        let [width, rows] = machine.size();
        machine.set_parameters(BandParameters {
            first_row: 0,
            rows,
            width,
            layers: 0,
            capacity: 0,
            before: 0,
        })
    }

    /// Fills the lists, of which number n has `counts[n]` fragments, and resolves each over what lies behind it. Returns
    /// the bytes of the lists.
    ///
    /// # Errors
    /// If the driver has no room.
    pub(in crate::low_level::methods) fn draw(
        &mut self,
        machine: &mut GlMachine<'_>,
        mut counts: Vec<u32>,
    ) -> Result<u64> {
        let width = machine.size()[0];
        let options = self.0.options;
        // No list: no fragment.
        counts.resize(counts.len().next_multiple_of(width as usize), 0);
        let budget = Budget {
            bytes: u64::MAX,
            fixed: 0,
            records: largest_storage(machine.context(), Texels::Rgba32Ui) / options.record_bytes(),
            preferred_band: u64::MAX,
        };
        let bands = bands(&counts, width, &options, budget)?;
        let bytes = self.allocate_marked(machine, &counts, &bands)?;
        let rows = (counts.len() as u32) / width;
        machine.allocate_rows(paper::COUNTER, Format::R32Ui, rows)?;
        machine.allocate_rows(edition::RESOLVED, Format::Rgba32F, rows)?;
        machine.framebuffer_with(paper::CLEARED, &[paper::COUNTER], None)?;
        machine.framebuffer_with(paper::RESOLVED, &[edition::RESOLVED], None)?;
        let behind = match self.has_opaque() {
            true => &edition::OPAQUE_BEHIND,
            false => &edition::BACKGROUND_BEHIND,
        };
        run(behind, &[], Variables::new(), machine)?;
        for call in [
            gl::glActiveTexture(2),
            gl::glBindTexture(paper::ANCHOR),
            gl::glActiveTexture(0),
        ] {
            machine.perform(&call)?;
        }
        self.0.layers = bands.iter().map(|band| band.layers).max().unwrap_or(0);
        self.0.inserts = inserts(&options, &counts, self.0.layers);
        let mut before = 0;
        for band in bands.iter().filter(|band| band.fragments > 0) {
            // The Resolve Step of the band before has disabled it.
            machine.perform(&gl::glEnable(gl::STENCIL_TEST))?;
            machine.set_screen(Some([0, band.first_row, width, band.rows]));
            machine.set_parameters(BandParameters {
                first_row: band.first_row,
                rows: band.rows,
                width,
                layers: band.layers,
                capacity: band.records(options.manager, width) as u32,
                // Offsets may have wrapped around; their differences are right all the same.
                before: before as u32,
            })?;
            self.0.draw_band(machine, band, &[])?;
            before += band.fragments;
        }
        machine.set_screen(None);
        Ok(bytes)
    }

    /// Makes the buffers as large as the largest band needs. Returns their bytes.
    fn allocate_marked(
        &self,
        machine: &mut GlMachine<'_>,
        counts: &[u32],
        bands: &[Band],
    ) -> Result<u64> {
        let width = machine.size()[0];
        let options = self.0.options;
        let records = bands.iter().map(|band| band.bytes(&options, width));
        let records = records.max().unwrap_or(0);
        machine.allocate_storage(paper::RECORDS, records, Some(Texels::Rgba32Ui))?;
        machine.bind_texels(RECORDS, paper::RECORDS)?;
        let mut next = 0u32;
        let offsets = counts.iter().map(|&count| {
            let offset = next;
            next = next.wrapping_add(count);
            offset
        });
        let offsets: Vec<u32> = offsets.collect();
        let bytes = 4 * offsets.len() as u64;
        machine.allocate_storage(paper::OFFSETS, bytes, None)?;
        machine.write_storage(paper::OFFSETS, bytemuck::cast_slice(&offsets))?;
        // A listing binds these, but dynamic buffers have no use for them.
        for storage in [paper::NEXT, paper::POOL] {
            machine.allocate_storage(storage, 16, None)?;
        }
        Ok(records + bytes)
    }
}
