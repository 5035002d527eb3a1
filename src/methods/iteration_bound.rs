//! A bound for the iterations of a peeling loop. It guards against printed listings, some of which never end.

use super::allocate_maps;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::stage;
use crate::steps::{Variables, run};

/// One iteration for each surface of the deepest pixel, and one that finds nothing. Every iteration of a right
/// algorithm takes at least one surface from every pixel that has any left.
pub(super) fn iteration_bound(machine: &mut GlMachine<'_>) -> Result<f64> {
    machine.begin_frame();
    let (color, depth) = (
        machine.format(stage::IMAGE_COLOR)?,
        machine.format(stage::OPAQUE_DEPTH)?,
    );
    allocate_maps(machine, &[&stage::COUNTING], color, depth)?;
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
    run(&stage::COUNT_AT_EACH_PIXEL, &[], Variables::new(), machine)?;
    let deepest = machine.read_counts(stage::COMPLEXITY)?.into_iter().max();
    machine.free(stage::COMPLEXITY);
    Ok(f64::from(deepest.unwrap_or(0)) + 1.0)
}
