//! A rendered frame.

use super::hanging::Hanging;
use super::stats::Stats;
use crate::image::Image;

/// An image and its facts.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Frame {
    /// The image.
    pub image: Image,
    /// The layers, nearest first, if the method keeps them.
    pub layers: Vec<Layer>,
    /// Which pixels hang on depths that a depth buffer cannot tell apart, if the method is [`Method::Exact`](super::Method::Exact).
    pub hanging: Option<Hanging>,
    /// The counts, and the time.
    pub stats: Stats,
    /// The time besides that of drawing.
    pub times: Times,
    /// Notes for the caller about things that do not affect the image: errors that OpenGL had pending before the frame,
    /// in someone else's context.
    pub notices: Vec<String>,
}

/// The milliseconds before and after the drawing, whose own are [`Stats::ms`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Times {
    /// Sorting and uploading triangles that stay from frame to frame, and making maps.
    pub set_up: f64,
    /// Counting what belongs in the image, and reading the image back.
    pub read_back: f64,
}

/// A peeled layer.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Layer {
    /// The colours, with straight alpha. All channels are 0 at a pixel without a fragment of the layer.
    pub color: Image,
    /// Window-space depth, row by row from the top. At a pixel without a fragment of the layer, it is the depth from
    /// which the peel started: the opaque surface's, or 1.
    pub depth: Vec<f32>,
}
