//! Being a guest in someone else's context: the state from which a frame starts, and the host's state, which is
//! restored after it.
//!
//! Every frame starts from [`known_state`]. A [`Visit`] keeps the host's values of this state and of every binding that
//! a machine changes, and restores them.
//!
//! Excludes state that does not affect what is drawn here: that of points and lines, patches, hints, multisampling,
//! seamless cube maps, viewports other than the first, and the host's own objects.

mod bindings;
mod fixed;
mod per_buffer;
mod visit;

pub use visit::Visit;

pub(in crate::low_level::gl) use bindings::UNITS;
pub(in crate::low_level::gl) use fixed::known_state;
