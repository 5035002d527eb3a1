//! How many iterations a peeling loop can need: a guard for listings as printed, some of which never end.

use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::vtk::{OPAQUE_DEPTH, OPAQUE_FIRST};
use crate::steps;
use crate::steps::{Dialect, Format, Listing, Map, Shader, Target, Variables, gl::*, run};

/// Transparent fragments before the opaque depth, added up by blending: exact up to 2^24 of them.
const DEPTH_COMPLEXITY: Listing = Listing {
    title: "How many surfaces each pixel has",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        run OPAQUE_FIRST;
        glBindFramebuffer(COMPLEXITY_TARGET);
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glClear(COLOR_BUFFER_BIT);
        glDepthMask(false);
        glEnable(BLEND);
        glBlendFunc(ONE, ONE);
        glUseProgram(Shader("complexity"));
        drawTransparentObjects();
    },
};

const COMPLEXITY: Map = Map::named("complexity");
const COMPLEXITY_TARGET: Target = Target("complexity");

/// One iteration for each surface of the deepest pixel, and one that finds nothing: every iteration of a right algorithm
/// takes at least one surface from every pixel that has any left.
pub(super) fn iteration_bound(machine: &mut GlMachine<'_>) -> Result<f64> {
    machine.begin_frame();
    machine.allocate(COMPLEXITY, Format::R32F)?;
    machine.target_of(COMPLEXITY_TARGET, &[COMPLEXITY], Some(OPAQUE_DEPTH))?;
    run(&DEPTH_COMPLEXITY, &[], Variables::new(), machine)?;
    let deepest = machine
        .read_colors(COMPLEXITY)?
        .iter()
        .map(|[count, ..]| f64::from(*count))
        .fold(0.0, f64::max);
    machine.free(COMPLEXITY);
    Ok(deepest + 1.0)
}
