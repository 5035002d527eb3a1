//! Being a guest in someone else's context: the state that a frame starts from, and the host's, which comes back after it.
//!
//! [`known_state`] is what every frame starts from. A [`Visit`] keeps what the host had set of it, and of every binding that
//! a machine changes, and puts that back.
//!
//! Excludes, because nothing of it reaches what is drawn here: the state of points and lines, patches, hints, multisampling
//! of samples that there are not, seamless cube maps, every viewport but the first, and the host's own objects.

mod bindings;
mod fixed;
mod per_buffer;
mod visit;

pub use visit::Visit;

pub(in crate::gl) use bindings::UNITS;
pub(in crate::gl) use fixed::known_state;
