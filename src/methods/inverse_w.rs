//! What can be drawn by 1/w instead of window-space depth.

use super::{DepthUnit0, Method};
use crate::error::{Error, Result};
use crate::gl::Format;

/// Says so where a method or a format cannot.
///
/// # Errors
/// Depths are not stored as 32-bit float, or the method compares window-space depths by other means than its shaders.
pub(super) fn check(method: &Method, depth: Format) -> Result<()> {
    if !matches!(depth, Format::Depth32F | Format::Depth32FStencil8) {
        return Err(Error::usage(
            format!("1/w is held by its bits, which {depth:?} does not keep"),
            "store depths as 32-bit float, or store window-space depth",
        ));
    }
    let what = match method {
        Method::DepthPeeling(options) if options.depth_unit_0 != DepthUnit0::default() => {
            "this way of comparing with depth unit 0 asks for window-space depth"
        }
        Method::CoherentLayerPeeling(options) if options.batches > 1 => {
            "depth batches are cut from window-space depth"
        }
        _ => return Ok(()),
    };
    Err(Error::usage(
        format!("{method} cannot be drawn by 1/w: {what}"),
        "draw by window-space depth, or choose another option",
    ))
}
