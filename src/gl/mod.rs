//! The GL machine, and everything that is unsafe.
//!
//! `glow` declares every GL call unsafe, because a call is only sound while its context is current on the calling
//! thread and its arguments fit the objects they name. Both are ensured in this module: a [`Context`] is made current
//! where it is used and cannot leave its thread, and other modules call GL only through the safe types here.

#![allow(unsafe_code)]

mod bindings;
mod capture;
pub mod classic;
mod constants;
mod context;
mod corner;
mod driver;
mod framebuffers;
mod geometry;
mod glsl;
mod host;
mod interpreter;
mod machine;
mod making;
mod maps;
mod merged;
mod more;
pub(crate) mod network;
mod numbers;
mod pixel_store;
mod program;
mod programs;
mod proxy;
mod queries;
mod quirks;
mod resources;
mod runs;
mod samplers;
mod scan;
mod step_times;
mod storage;
mod texture;
mod trap;
#[cfg(test)]
mod units;
mod uploading;
mod volumes;
mod watched;
mod window;
mod witness;

pub(crate) use bindings::{BandParameters, LINKS, PIECES, RECORDS};
pub use capture::{Captured, CapturedFragment, capture};
pub(crate) use capture::{Piece, capture_at, capture_in_pieces};
pub use classic::{ClassicState, FixedFunction};
pub use context::{Backend, Context, ContextOptions, Profile, suspect_variables};
pub use driver::{Driver, Trap, WANTED_EXTENSIONS};
pub use geometry::Geometry;
pub use glsl::{shader_file, shaders};
pub use host::Visit;
pub use machine::{Counts, GlMachine};
pub use numbers::Numbers;
pub use quirks::{LoopLimit, Quirks};
pub(crate) use scan::CHUNK;
pub use step_times::StepTime;
pub use storage::{Texels, largest_storage};
pub use volumes::MOST_VOLUMES;
pub use witness::{DrawnOrder, Seen, Setting, Witness};

// A map's format is part of the vocabulary.
pub use crate::steps::Format;
