//! A method as the renderer sees it: it is prepared for a scene, and then draws frames.

use super::hanging::Hanging;
use super::stats::{ABufferCounts, Chosen, Peeling, VerifiedCounts};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::image::Image;
use crate::scene::{Camera, Scene};
use crate::steps::Reason;

/// A method at work on one scene.
pub trait Algorithm {
    /// In which order the scene's triangles are uploaded and drawn. It is asked for once, before the upload; no frame's time
    /// contains it.
    fn order(&mut self, _: &Scene) -> DrawOrder {
        DrawOrder::Submission
    }

    /// Gets what every frame needs: maps, framebuffers. Not part of a frame's time.
    ///
    /// # Errors
    /// If the driver fails, or an option is out of its range.
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()>;

    /// Draws a frame into [`IMAGE_COLOR`](crate::papers::stage::IMAGE_COLOR). The machine is in GL's initial state,
    /// except for the clear colour, which is the background's.
    ///
    /// # Errors
    /// If the driver fails.
    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn>;

    /// Counts what the last frame did or left out, if that takes draws or time that are not part of the method.
    ///
    /// # Errors
    /// If the driver fails.
    fn account(&mut self, _: &mut GlMachine<'_>, _: &mut Drawn) -> Result<()> {
        Ok(())
    }
}

/// In which order triangles are uploaded and drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DrawOrder {
    /// As the scene has them.
    Submission,
    /// Each triangle as mesh and number.
    Sorted(Vec<[u32; 2]>),
    /// Several orders, which need not have every triangle. Frames begin with the first one;
    /// [`GlMachine::choose_order`] chooses another.
    InTurn(Vec<Vec<[u32; 2]>>),
    /// Nothing transparent is drawn but what the method submits itself, frame by frame
    /// ([`GlMachine::submit_triangles`]).
    Own,
}

/// How a renderer draws, whatever the method.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// The image's width and height in pixels.
    pub size: [u32; 2],
    /// The format of the image and of layers.
    pub color: Format,
    /// The format of every depth buffer.
    pub depth: Format,
    /// Whether frames record values that only their statistics need.
    pub counts_costs: bool,
    /// The scene's camera as it was given. It may be drawn with other clip planes.
    pub given: Camera,
}

/// The result of a method's frame.
#[derive(Debug, Default)]
pub struct Drawn {
    /// The rounds of its loop, including the last one even if it found nothing.
    pub iterations: u32,
    /// The layers in the image, or `None` if the method has no layers.
    pub layers: Option<u32>,
    /// Whether each layer is kept in the maps `layer N` and `layer depth N`.
    pub keeps_layers: bool,
    /// The fragments in the image.
    pub composited: Composited,
    /// The fragments that were not merged with others, or `None` if the method merges none or does not count them.
    pub unmerged: Option<u64>,
    /// The reason for which its loop ended, or `None` if it has no loop.
    pub stopped: Option<Reason>,
    /// Whether depth peeling was used.
    pub peeling: Peeling,
    /// The costs of its lists, or `None` if it has none.
    pub a_buffer: Option<ABufferCounts>,
    /// What could not be proved to be in order, or `None` if the method proves nothing.
    pub verified: Option<VerifiedCounts>,
    /// The method that drew the frame, or `None` if it was not chosen automatically.
    pub chosen: Option<Chosen>,
    /// The image, or `None` if it is in the map [`IMAGE_COLOR`](crate::papers::stage::IMAGE_COLOR).
    pub image: Option<Image>,
    /// The pixels that depend on depths that cannot be told apart, or `None` if the method has not looked for them.
    pub hanging: Option<Hanging>,
}

/// The transparent fragments in the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Composited {
    /// All of them, in any order.
    #[default]
    All,
    /// So many of them.
    Some(u64),
    /// All but so many of them.
    Lost(u64),
    /// The method cannot tell.
    Unknown,
}

impl Composited {
    /// The number of fragments, or `None` if it is not known.
    pub(super) fn count(self) -> u64 {
        match self {
            Self::Some(count) => count,
            Self::All | Self::Lost(_) | Self::Unknown => 0,
        }
    }
}
