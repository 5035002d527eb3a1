//! What a method is to the renderer: something that is prepared for a scene, and then draws frames.

use super::hanging::Hanging;
use super::stats::{ABufferCounts, Peeling};
use crate::error::Result;
use crate::gl::{Format, GlMachine};
use crate::image::Image;
use crate::scene::{Camera, Scene};
use crate::steps::Reason;

/// A method at work on one scene.
pub trait Algorithm {
    /// Gets what every frame needs: maps, framebuffers. Not part of a frame's time.
    ///
    /// # Errors
    /// What the driver cannot do, and options out of their range.
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()>;

    /// Draws one frame into [`IMAGE_COLOR`](crate::papers::stage::IMAGE_COLOR). The machine is in GL's initial state, but for the clear colour, which is the
    /// background's.
    ///
    /// # Errors
    /// What the driver cannot do.
    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn>;

    /// Counts what the last frame did or left out, where that takes draws or time that are no part of the method.
    ///
    /// # Errors
    /// What the driver cannot do.
    fn account(&mut self, _: &mut GlMachine<'_>, _: &mut Drawn) -> Result<()> {
        Ok(())
    }
}

/// How a renderer draws, whatever the method.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// The format of the image and of layers.
    pub color: Format,
    /// The format of every depth buffer.
    pub depth: Format,
    /// Whether frames contain what is written down for statistics only.
    pub counts_costs: bool,
    /// The scene's camera as it was given, whatever clip planes it is drawn with.
    pub given: Camera,
}

/// What a method has done in a frame.
#[derive(Debug, Default)]
pub struct Drawn {
    /// Rounds of its loop, the last one included even if it found nothing.
    pub iterations: u32,
    /// Layers that are in the image, or `None` if the method has no layers.
    pub layers: Option<u32>,
    /// Whether each layer is kept in the maps `layer N` and `layer depth N`.
    pub keeps_layers: bool,
    /// Which fragments are in the image.
    pub composited: Composited,
    /// Why its loop ended, or `None` if it has no loop.
    pub stopped: Option<Reason>,
    /// Whether depth peeling was used.
    pub peeling: Peeling,
    /// What its lists have cost, if it has any.
    pub a_buffer: Option<ABufferCounts>,
    /// The image, if it is not in the map [`IMAGE_COLOR`](crate::papers::stage::IMAGE_COLOR).
    pub image: Option<Image>,
    /// Which pixels hang on depths that cannot be told apart, if the method has looked.
    pub hanging: Option<Hanging>,
}

/// Which of the transparent fragments are in the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Composited {
    /// All, in whatever order.
    #[default]
    All,
    /// So many.
    Some(u64),
    /// All but so many.
    AllBut(u64),
    /// The method cannot tell.
    Unknown,
}

impl Composited {
    /// How many, as far as that is known.
    pub(super) fn count(self) -> u64 {
        match self {
            Self::Some(count) => count,
            Self::All | Self::AllBut(_) | Self::Unknown => 0,
        }
    }
}
