//! Checking that a method can be drawn by 1/w instead of window-space depth.

use super::technique::Technique;
use crate::error::{Error, Result};
use crate::gl::Format;

/// Checks that the method and the format allow 1/w.
///
/// # Errors
/// If depths are not stored as 32-bit floats, or if something other than the method's shaders compares window-space
/// depths.
pub(super) fn check(method: &dyn Technique, depth: Format) -> Result<()> {
    if !matches!(depth, Format::Depth32F | Format::Depth32FStencil8) {
        return Err(Error::option(
            "depth",
            format!("1/w is held by its bits, which {depth} does not keep"),
            "store depths as 32-bit float, or store window-space depth",
        ));
    }
    let Some(what) = method.needs_window_depth() else {
        return Ok(());
    };
    Err(Error::option(
        "inverse-w",
        format!("{} cannot be drawn by 1/w: {what}", method.entry().name),
        "draw by window-space depth, or choose another option",
    ))
}
