//! The vocabulary of listings: what the papers print, as plain data.
//!
//! # The model
//!
//! A [`Listing`] is a tree of [`Step`]s, a constant that reads like the paper (see the [`steps!`](crate::steps!)
//! macro). Its leaves are [`Call`]s: state, clears, binds, copies, queries and draws, spelled as OpenGL spells them.
//! Its branches are what the papers write around the calls: loops, variables, conditions, and *stop* steps that leave
//! a loop and say why.
//!
//! One constant, many readers:
//!
//! - [`run`] walks the tree, evaluates the variables, and hands each call, with every name resolved, to a [`Machine`].
//!   GL is one machine (`gl/`), [`Recorder`] is another, which records the flat trace.
//! - [`DepthUnits`] stands between the two if a listing asks for an OpenGL with several depth units. It turns such
//!   calls into calls of a real OpenGL.
//! - [`print`](mod@print) writes a listing as its paper does, which tests hold against a transcript.
//!
//! State persists from listing to listing, as in GL. Nothing here resets state that the listing does not reset.
//!
//! Where a printed listing is wrong, or where another text extends it, an [`Amendment`] says which steps are replaced
//! by which. Listings themselves are never edited: everybody who reads one walks it with amendments in place
//! ([`Scope::walk`]).
//!
//! What a listing takes for granted - maps, framebuffers, buffers, variables - stands beside it as [`Resources`].
//! [`check`] holds every name in a listing against them before anything runs.
//!
//! Some papers print pseudocode instead ([`pseudo`]). A [`Text`] is a listing or pseudocode, with its amendments.

mod amend;
mod argument;
mod call;
mod check;
mod classic;
mod classic_depth_units;
mod constants;
mod depth_units;
mod expr;
mod format;
mod free;
pub mod gl;
mod gl_classic;
mod held;
mod lines;
mod listing;
mod macros;
mod names;
mod origin;
pub mod print;
pub mod pseudo;
mod reading;
mod resources;
mod text;
mod trace;
mod walk;

pub use amend::{Met, Ran, Scope, Spelling, Statement};
pub use call::{Call, ClassicCall};
pub use check::{Known, check};
pub use classic::{
    ClassicCapability, CombinerComponent, CombinerMapping, CombinerRegister, CombinerVariable,
    DepthTextureMode, MatrixMode, TexEnvName, TexEnvValue, TextureTarget,
};
pub use classic_depth_units::ClassicDepthUnits;
#[cfg(test)]
pub(crate) use constants::NUMBERS;
pub use constants::{BlendEquation, BlendFactor, Buffers, Capability, Compare, Objects, StencilOp};
pub use depth_units::DepthUnits;
pub use expr::{Condition, Expr, Variables};
pub use format::Format;
pub use free::free_variables;
pub use held::{Held, Texel};
pub use lines::TextLine;
pub use listing::{Amendment, Dialect, Listing, Reason, Step};
pub use names::{Index, Map, Name, Number, Query, Shader, Storage, Target};
pub use origin::{Kind, Margin, Origin};
pub use reading::Reading;
pub use resources::{Framebuffer, Holds, Resources};
pub use text::Text;
pub use trace::Recorder;
pub use walk::{CallLine, Machine, Outcome, Workspace, run};
