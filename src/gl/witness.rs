//! Somebody who watches a machine at work: told of each call with its line, shown what a pixel holds after it.

use super::numbers::Numbers;
use crate::error::Result;
use crate::steps::{Call, CallLine, Format, Held, Map, Target};

/// A witness of a machine's work ([`GlMachine::set_witness`](crate::gl::GlMachine::set_witness)). Work that is not the
/// method's ([`GlMachine::save_and_restore`](crate::gl::GlMachine::save_and_restore)) is not shown to it.
pub trait Witness {
    /// A map has been made, unless it was there in this format.
    ///
    /// # Errors
    /// The witness's own.
    fn allocated(&mut self, map: Map, format: Format) -> Result<()>;

    /// A framebuffer has been given these maps.
    ///
    /// # Errors
    /// The witness's own.
    fn framed(&mut self, target: Target, colors: &[Map], depth: Option<Map>) -> Result<()>;

    /// The next call comes from this line. Calls that a method makes by itself come from none.
    fn follow(&mut self, line: &CallLine);

    /// A call has been performed.
    ///
    /// # Errors
    /// The witness's own.
    fn performed(&mut self, call: &Call, seen: &Seen<'_>) -> Result<()>;

    /// Something has been set that no call sets.
    fn set(&mut self, setting: Setting<'_>);
}

/// What a witness sees of a machine after a call.
pub struct Seen<'a> {
    /// The name of the program that draws now, or `None` if a listing has chosen none.
    pub program: Option<&'a str>,
    /// The width and height of the machine's images.
    pub size: [u32; 2],
    /// The values that a pixel of the bound framebuffer holds. The pixel is in column x from the left and row y from the
    /// bottom.
    pub held: &'a dyn Fn([u32; 2]) -> Held,
    /// The whole numbers that all pixels of a map hold, row by row from the bottom.
    pub counts: &'a dyn Fn(Map) -> Result<Vec<u32>>,
}

/// What a method sets by itself, besides its listing's calls.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Setting<'s> {
    /// Surfaces are drawn in this order.
    Order(DrawnOrder<'s>),
    /// Programs that are used from now on have these `#define`s, names and values.
    Defines(&'s [(&'static str, u32)]),
    /// Only so many rows from the first one on are drawn, counted from the bottom. With `None`, all.
    Band(Option<[u32; 2]>),
    /// Draws over the screen cover these pixels: x, y, width and height. With `None`, the window.
    Screen(Option<[u32; 4]>),
    /// Transparent surfaces are in these pixels only: x, y, width and height.
    Window([u32; 4]),
    /// Marked pixels have lists of their own, by number.
    Numbers(&'s Numbers),
    /// A fixed buffer has room for so many records at each pixel.
    Layers(u32),
}

/// The order in which triangles are drawn.
#[derive(Clone, Copy, Debug)]
pub enum DrawnOrder<'o> {
    /// All of them, in the order of submission.
    Submission,
    /// These, each as mesh and number.
    Triangles(&'o [[u32; 2]]),
    /// These of the transparent meshes, each as its corners, which are numbers of vertices through all transparent meshes.
    /// Opaque ones are drawn in the order of submission.
    Corners(&'o [[u32; 3]]),
}

/// The witness of a machine.
#[derive(Default)]
pub(super) struct Watch(pub(super) Option<Box<dyn Witness>>);

impl Watch {
    pub(super) fn tell(&mut self, tell: impl FnOnce(&mut dyn Witness) -> Result<()>) -> Result<()> {
        match &mut self.0 {
            Some(witness) => tell(witness.as_mut()),
            None => Ok(()),
        }
    }

    pub(super) fn follow(&mut self, line: &CallLine) {
        if let Some(witness) = &mut self.0 {
            witness.follow(line);
        }
    }

    pub(super) fn set(&mut self, setting: Setting<'_>) {
        if let Some(witness) = &mut self.0 {
            witness.set(setting);
        }
    }
}
