//! Pixels whose colour depends on a difference of depth that a depth buffer cannot hold.

/// For each pixel of an exact image, whether it depends on such a difference, row by row from the top. At such a pixel,
/// two surfaces are so near to each other that a rasteriser may see them in either order, and the order makes a visible
/// difference.
///
/// If a picture differs from the exact one only in such pixels, its renderer is as right as its depth buffer allows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Hanging {
    /// With the clip planes with which methods are drawn:
    /// [`Renderer::with_given_planes`](super::Renderer::with_given_planes).
    pub drawn: Vec<bool>,
    /// With the clip planes of the scene's camera, which another renderer may use unchanged. Its rasteriser is not known, so
    /// it may snap corners to a grid of 1/256 pixel before it interpolates depths.
    pub given: Vec<bool>,
}
