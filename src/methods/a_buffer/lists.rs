//! The lists' buffers. They are made once and used by one band after the other. The base offsets are those of the whole
//! image.

use super::bands::Band;
use super::options::{Fill, Manager};
use super::{ABuffer, paper};
use crate::error::Result;
use crate::gl::{BandParameters, GlMachine, LINKS, RECORDS, Texels};
use crate::papers::stage;
use crate::steps::Storage;

/// Buffers that a listing binds even if the manager has no use for them.
const UNUSED: [Storage; 3] = [paper::NEXT, paper::OFFSETS, paper::POOL];

impl ABuffer {
    /// Makes the buffers as large as the largest band needs, and scans for the base offsets.
    pub(super) fn allocate_lists(&self, machine: &mut GlMachine<'_>, bands: &[Band]) -> Result<()> {
        let width = machine.size()[0];
        let options = &self.options;
        let records = bands
            .iter()
            .map(|band| band.records(options.manager, width))
            .max()
            .unwrap_or(0);
        let bytes = records * options.color.record_bytes();
        for storage in UNUSED {
            machine.allocate_storage(storage, 16, None)?;
        }
        machine.allocate_storage(paper::RECORDS, bytes, Some(Texels::Rgba32Ui))?;
        machine.bind_texels(RECORDS, paper::RECORDS)?;
        if options.manager == Manager::Ppll {
            machine.allocate_storage(paper::NEXT, records * 4, Some(Texels::R32Ui))?;
            machine.bind_texels(LINKS, paper::NEXT)?;
        }
        if options.has_offsets() {
            machine.prefix_scan(stage::COMPLEXITY, paper::OFFSETS)?;
        }
        Ok(())
    }

    /// Prepares the buffers for a band. `before` fragments are in earlier bands.
    pub(super) fn begin_band(
        &self,
        machine: &mut GlMachine<'_>,
        band: &Band,
        fragments_before: u64,
    ) -> Result<()> {
        let width = machine.size()[0];
        let options = &self.options;
        let records = band.records(options.manager, width) as u32;
        machine.set_band(Some([band.first_row, band.rows]));
        machine.set_parameters(BandParameters {
            first_row: band.first_row,
            rows: band.rows,
            width,
            layers: band.layers,
            capacity: records,
            // All offsets may have wrapped around; their differences are right all the same.
            before: fragments_before as u32,
        })?;
        if options.manager == Manager::Ppll && options.fill == Fill::Atomics {
            machine.clear_storage(paper::POOL)?;
        }
        Ok(())
    }
}
