//! What is told of a run on lists, line by line.

use super::pixel::{Pixel, Resolved, orders};
use crate::steps::pseudo::list::ListLine;

/// A line that an algorithm has just executed, and what the pixels hold now.
pub struct ExecutedListLine<'a> {
    /// The line.
    pub line: &'a ListLine,
    /// The pixel, or `None` of a line for all of them.
    pub pixel: Option<usize>,
    /// The fragment, by its place in the order of submission.
    pub fragment: Option<u32>,
    /// i, or the size of the Local Array.
    pub size: u32,
    /// Whether the test of an `if` holds, or the end of a `repeat` has come.
    pub holds: Option<bool>,
    pub(super) pixels: &'a [Pixel<'a>],
}

/// What a pixel holds while its list is resolved.
pub struct ListState<'a> {
    /// The depth complexity that was counted, and its stencil value.
    pub complexity: u32,
    /// Likewise.
    pub stencil: u8,
    /// Whether the pixel is marked as resolved.
    pub marked: bool,
    /// ppDP's buffer once there is one, nearest first. Fragments are given by their places in the order of submission.
    pub buffer: Option<Vec<u32>>,
    /// Min depth and min id once they are set; `i64::MAX` is every id at that depth.
    pub min: Option<(f32, i64)>,
    /// What was done so far.
    pub done: &'a Resolved,
}

impl ExecutedListLine<'_> {
    /// What a pixel holds now.
    pub fn state(&self, pixel: usize) -> ListState<'_> {
        let pixel = &self.pixels[pixel];
        let peel = pixel.peel.as_ref();
        ListState {
            complexity: pixel.complexity,
            stencil: pixel.stencil,
            marked: pixel.marked,
            buffer: peel.map(|peel| orders(&peel.buffer)),
            min: peel.and_then(|peel| peel.min),
            done: &pixel.done,
        }
    }
}
