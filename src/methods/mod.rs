//! The methods: one file each, which reads like its paper, and the renderer that runs them.

mod a_buffer;
mod allocate_maps;
mod batches;
mod blend;
mod coherent_layer_peeling;
mod complexity;
pub mod coplanar;
mod coplanar_depth_peeling;
mod depth_peeling;
mod depth_unit_0;
mod dual_depth_peeling;
mod exact;
mod hanging;
mod hybrid_layer_peeling;
mod ideal_coherent_layer_peeling;
pub mod invariance;
mod inverse_w;
mod iteration_bound;
mod layer_peeling;
mod painter;
mod peeled;
mod registry;
mod renderer;
mod requirements;
mod slicing;
mod sorting;
mod stats;
#[cfg(test)]
mod volume_controls;

pub use a_buffer::{
    ABufferCounts, ABufferOptions, Band, Fill, Keep, LARGEST_NETWORK, Manager, RecordColor, Room,
    Sort, bands,
};
pub use allocate_maps::allocate_maps;
pub use batches::begin_batch;
pub use coherent_layer_peeling::{CoherentOptions, Variant};
pub use complexity::{Bin, Complexity, CountBy};
pub use coplanar_depth_peeling::CoplanarDepthPeelingOptions;
pub use depth_peeling::{Compositing, DepthPeelingOptions};
pub use depth_unit_0::{DepthSource, DepthUnit0, Place, Trial};
pub use dual_depth_peeling::DualDepthPeelingOptions;
pub use hanging::Hanging;
pub use ideal_coherent_layer_peeling::{BufferAccess, IdealOptions};
pub use layer_peeling::LayerPeelingOptions;
pub use registry::{Entry, Method, registry};
pub use renderer::{Frame, Layer, Renderer};
pub use slicing::{DEFAULT_SLICES, MOST_SLICES};
pub use sorting::Sorting;
pub use stats::{Peeling, Stats};

use crate::error::Result;
use crate::gl::GlMachine;
use crate::image::Image;
use crate::scene::Scene;
use crate::steps::Reason;

/// One published method, set up for a scene.
trait Algorithm {
    /// Gets what every frame needs: maps, framebuffers. Not part of a frame's time.
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()>;

    /// Draws one frame. The machine is in GL's initial state, but for the clear colour, which is the background's.
    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn>;

    /// Counts what the last frame did or left out, where that takes draws or time that are no part of the method.
    fn account(&mut self, _: &mut GlMachine<'_>, _: &mut Drawn) -> Result<()> {
        Ok(())
    }
}

/// What a method has done in a frame.
#[derive(Debug, Default)]
struct Drawn {
    /// Rounds of its loop, the last one included even if it found nothing.
    iterations: u32,
    /// Layers that are in the image; nothing if the method has none.
    layers: Option<u32>,
    /// Fragments that are in the image; nothing if the method cannot tell.
    composited: Composited,
    /// Why its loop ended; nothing if it has none.
    stopped: Option<Reason>,
    /// Whether depth peeling was used.
    peeling: Peeling,
    /// What its lists have cost, if it has any.
    a_buffer: Option<ABufferCounts>,
    /// The image, if it is not in the map `image`.
    image: Option<Image>,
    /// Which pixels hang on depths that cannot be told apart, if the method has looked.
    hanging: Option<Hanging>,
}

/// Which of the transparent fragments are in the image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Composited {
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
    fn count(self) -> u64 {
        match self {
            Self::Some(count) => count,
            Self::All | Self::AllBut(_) | Self::Unknown => 0,
        }
    }
}
