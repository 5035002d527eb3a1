//! Every pixel's complexity, counted before lists are made.

use super::ABuffer;
use super::bands::deepest;
use crate::error::{Error, Result};
use crate::gl::GlMachine;
use crate::papers::lindholm_2015 as paper;
use crate::papers::stage;
use crate::steps::{Amendment, Variables, run};

/// Checks that there is a stencil buffer in which to count, or in which to mark pixels.
///
/// # Errors
/// If the depth format has no stencil.
pub(in crate::low_level::methods) fn expect_stencil(machine: &GlMachine<'_>) -> Result<()> {
    let format = machine.format(stage::OPAQUE_DEPTH)?;
    if format.has_stencil() {
        return Ok(());
    }
    Err(Error::option(
        "depth",
        format!("there is no stencil buffer to count in: depths are stored as {format}"),
        "choose a depth format with a stencil, or count by blending (ppAO: amended)",
    ))
}

/// The largest count of the stencil buffer that is certainly right.
const STENCIL_COUNTS: u32 = 254;

impl ABuffer {
    /// The number of records that every pixel needs room for: its complexity, or what a fixed buffer has. The stencil
    /// buffer counts it if that is enough, because it is quicker. But a prefix scan needs colours.
    pub(super) fn count(
        &mut self,
        machine: &mut GlMachine<'_>,
        amendments: &[Amendment],
    ) -> Result<Vec<u32>> {
        if let Some(layers) = self.options.fixed_layers {
            let [width, height] = machine.size();
            return Ok(vec![layers; (width * height) as usize]);
        }
        let depth = Some(stage::OPAQUE_DEPTH);
        if !self.options.has_offsets() && machine.format(stage::OPAQUE_DEPTH)?.has_stencil() {
            machine.framebuffer_with(stage::COUNTED, &[], depth)?;
            let variables = Variables::new();
            run(&paper::COUNT_BY_STENCIL, amendments, variables, machine)?;
            self.counts.counting_passes += 1;
            let counts = machine.read_counts(stage::OPAQUE_DEPTH)?;
            if deepest(&counts) <= STENCIL_COUNTS {
                return Ok(counts);
            }
        }
        machine.framebuffer_with(stage::COUNTED, &[stage::COMPLEXITY], depth)?;
        let variables = Variables::new();
        run(&stage::COUNT_AT_EACH_PIXEL, amendments, variables, machine)?;
        self.counts.counting_passes += 1;
        machine.read_counts(stage::COMPLEXITY)
    }
}
