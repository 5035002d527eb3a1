//! What is drawn at each pixel, before any method.

use crate::error::Result;
use crate::gl::{CapturedFragment, Context, Geometry, GlMachine, capture};
use crate::methods::allocate_maps;
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Format, Variables, run};

/// Every transparent fragment that no opaque surface hides, in the order of submission.
///
/// # Errors
/// If the driver fails.
pub fn fragments(context: &Context, scene: &Scene) -> Result<Vec<CapturedFragment>> {
    let mut machine = GlMachine::new(context, scene.size)?;
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut machine, &[&stage::RESOURCES], color, depth)?;
    machine.set_geometry(Geometry::upload(context, scene, scene.size)?);
    machine.begin_frame();
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut machine)?;
    let mut fragments = capture(&mut machine, stage::OPAQUE_DEPTH, u32::MAX)?;
    fragments.sort_by_key(|fragment| (fragment.order, fragment.y, fragment.x));
    Ok(fragments)
}

/// The depths of the fragments in the column of pixels that has most of them, pixel by pixel from the top.
///
/// # Errors
/// If the driver fails.
pub fn deepest_column(context: &Context, scene: &Scene) -> Result<Vec<Vec<f32>>> {
    let [width, height] = scene.size.map(|pixels| pixels as usize);
    let mut columns = vec![vec![Vec::new(); height]; width];
    for fragment in fragments(context, scene)? {
        let row = height - 1 - fragment.y as usize;
        columns[fragment.x as usize][row].push(fragment.depth);
    }
    let count = |column: &Vec<Vec<f32>>| -> usize { column.iter().map(Vec::len).sum() };
    Ok(columns.into_iter().max_by_key(count).unwrap_or_default())
}
