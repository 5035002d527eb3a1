//! Volumes for methods that draw surfaces only: as slices (Carr et al. 2008, whose sorted geometry they are).

use super::entry::{Entry, Volumes};
use super::registry::registry;
use crate::error::{Error, Result};
use crate::scene::Scene;

/// As many slices as volumes are drawn as if nobody says how many: Carr et al.'s figure 1 has 256.
pub const DEFAULT_SLICES: u32 = 256;
/// The most slices that can be asked for.
pub const MOST_SLICES: u32 = 1 << 16;

/// Whether there can be so many slices.
pub(super) fn check(count: u32) -> Result<()> {
    if (1..=MOST_SLICES).contains(&count) {
        return Ok(());
    }
    Err(Error::usage(
        format!("volumes cannot be drawn as {count} slices"),
        format!("choose from 1 to {MOST_SLICES}"),
    ))
}

/// As how many slices the method draws the scene's volumes, `asked` by the user or not; none if it casts rays through
/// them, or there are no volumes.
///
/// # Errors
/// The method would leave the volumes out in silence.
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
        remedy += &format!(
            "; or have {} draw them as N slices, with --slices N",
            method.name
        );
    }
    Error::usage(
        format!(
            "{} draws surfaces only, and the scene has volumes ({})",
            method.name,
            scene.volumes.len()
        ),
        remedy,
    )
}
