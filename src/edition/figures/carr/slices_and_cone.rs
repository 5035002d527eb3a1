//! Slices through a volume and a cone through them (figures 1 and 3).

use crate::error::Result;
use crate::scene::Scene;
use crate::scene::generate::{Slices, SubmissionOrder, slices};

/// The bundled scene `slices` with so many slices, front to back, in place of its own. Each is a grid of `cells` times `cells`
/// cells. All slices together are as opaque whatever their number.
///
/// # Errors
/// A parameter is out of its range.
pub fn with_slices(mut scene: Scene, count: u32, cells: u32) -> Result<Scene> {
    scene.meshes[0] = slices(&Slices {
        count,
        cells,
        alpha: (12.8 / count as f32).min(1.0),
        order: SubmissionOrder::FrontToBack,
        ..Slices::default()
    })?;
    scene.meshes[0].sorted = true;
    Ok(scene)
}
