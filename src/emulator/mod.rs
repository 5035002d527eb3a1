//! The emulated pixel: GL's operations on fragments, with one function per stage, run step by step.
//!
//! It runs the same [steps](mod@crate::steps) as the GL machine, on pixels whose fragments are given as lists. It can
//! record what happens to every fragment of one pixel, as a table that a student can follow ([`Record`]). Algorithms in
//! [pseudocode](crate::steps::pseudo) run on the same lists ([`run_algorithm`]). Algorithms on lists in memory, as
//! A-buffers have them, run on the lists alone ([`run_on_lists`]), or with rays cast between the fragments
//! ([`run_on_rays`]).
//!
//! # The model
//!
//! A pixel is a list of [`Surface`]s in the order of submission. A draw sends its surfaces, one after the other,
//! through the shader's twin (in `shaders`) and then through the stages in GL's order (`stages`): stencil test, depth
//! test, occlusion count, blending, masks, writing. Pixels are independent of each other; only a query adds them up.
//!
//! Excludes: several samples per pixel, several color maps at once, scissors, dithering, logic ops, sRGB, and everything
//! before the fragment: depths and colours are given, not interpolated.

mod color;
mod depth;
mod invocation;
mod lists;
mod machine;
mod place;
mod pseudo;
mod record;
mod shaders;
mod stages;
mod state;

pub use lists::{
    ListRun, RayEvent, RayHappening, RayRun, RayScene, RayVolume, Resolved, run_on_lists,
    run_on_rays,
};
pub use machine::{Emulator, Group, Surface};
pub use pseudo::{AlgorithmRun, run_algorithm};
pub use record::{Draw, Fate, FragmentOutcome, Record};
