//! Volumes for methods that draw surfaces only: as slices (Carr et al. 2008, whose sorted geometry they are).

use super::{Method, registry};
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
pub(super) fn slices(scene: &Scene, method: &Method, asked: Option<u32>) -> Result<Option<u32>> {
    if scene.volumes.is_empty() || method.casts_rays() {
        return Ok(None);
    }
    let unasked = method.renders_volumes().then_some(DEFAULT_SLICES);
    match asked.or(unasked) {
        Some(count) if method.takes_slices() => Ok(Some(count)),
        _ => Err(refusal(scene, method)),
    }
}

fn refusal(scene: &Scene, method: &Method) -> Error {
    let entries = registry().iter();
    let able = entries.filter(|entry| entry.method.renders_volumes());
    let able: Vec<_> = able.map(|entry| entry.name).collect();
    let mut remedy = format!("volumes are rendered by: {}", able.join(", "));
    if method.takes_slices() {
        remedy += &format!("; or have {method} draw them as N slices, with --slices N");
    }
    Error::usage(
        format!(
            "{method} draws surfaces only, and the scene has volumes ({})",
            scene.volumes.len()
        ),
        remedy,
    )
}
