//! Pixels whose colour hangs on a difference of depth that a depth buffer cannot hold.

/// Which pixels of an exact image hang on such a difference, row by row from the top: two surfaces lie so near to each
/// other there that a rasteriser may see them in either order, and it shows.
///
/// Where a picture differs from the exact one only in such pixels, its renderer is right as far as its depth buffer goes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Hanging {
    /// With the clip planes that methods are drawn with: [`Renderer::with_given_planes`](super::Renderer::with_given_planes).
    pub drawn: Vec<bool>,
    /// With the clip planes of the scene's camera, which another renderer may take as they are.
    pub given: Vec<bool>,
}
