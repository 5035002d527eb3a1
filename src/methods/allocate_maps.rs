//! The maps and framebuffers that listings take for granted.

use crate::error::Result;
use crate::steps::{Format, Resources, Workspace};

/// Gives a machine everything that these resources say: maps, colours in the format `color` and depths in the format
/// `depth`, and framebuffers that draw into them.
///
/// # Errors
/// If there is no room, or the machine cannot draw into maps of these formats together.
pub fn allocate_maps(
    workspace: &mut impl Workspace,
    resources: &[&Resources],
    color: Format,
    depth: Format,
) -> Result<()> {
    for resources in resources {
        for (map, holds) in resources.maps {
            workspace.allocate(*map, holds.format(color, depth))?;
        }
        for framebuffer in resources.framebuffers {
            workspace.framebuffer_with(
                framebuffer.target,
                framebuffer.colors,
                framebuffer.depth,
            )?;
        }
    }
    Ok(())
}
