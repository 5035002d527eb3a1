//! Volumes as slices, for methods that draw only surfaces (Carr et al. 2008, whose sorted geometry they are).

use super::entry::{Entry, Volumes};
use super::registry::registry;
use crate::error::{Error, Result};
use crate::scene::Scene;

/// The default number of slices, as in figure 1 of Carr et al.
pub const DEFAULT_SLICES: u32 = 256;
/// The largest number of slices.
pub const MOST_SLICES: u32 = 1 << 16;

/// Checks the number of slices.
pub(super) fn check(count: u32) -> Result<()> {
    if (1..=MOST_SLICES).contains(&count) {
        return Ok(());
    }
    Err(Error::option(
        "slices",
        format!("volumes cannot be drawn as {count} slices"),
        format!("choose from 1 to {MOST_SLICES}"),
    ))
}

/// How many slices the method draws the scene's volumes as: `asked`, or the default. `None` if it casts rays through
/// them, or if there are no volumes.
///
/// # Errors
/// If the method would leave the volumes out in silence.
pub(super) fn slices(scene: &Scene, method: &Entry, asked: Option<u32>) -> Result<Option<u32>> {
    if scene.volumes.is_empty() || method.volumes == Volumes::Rays {
        return Ok(None);
    }
    let unasked = method.volumes.are_rendered().then_some(DEFAULT_SLICES);
    match asked.or(unasked) {
        Some(count) if method.volumes.take_slices() => Ok(Some(count)),
        _ => Err(refusal(scene, method)),
    }
}

fn refusal(scene: &Scene, method: &Entry) -> Error {
    let entries = registry().iter();
    let able = entries.filter(|entry| entry.volumes.are_rendered());
    let able: Vec<_> = able.map(|entry| entry.name).collect();
    let mut remedy = format!("volumes are rendered by: {}", able.join(", "));
    if method.volumes.take_slices() {
        remedy += &format!("; or have {} draw them as N slices", method.name);
    }
    Error::option(
        "slices",
        format!(
            "{} draws surfaces only, and the scene has volumes ({})",
            method.name,
            scene.volumes.len()
        ),
        remedy,
    )
}
