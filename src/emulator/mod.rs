//! The emulated pixel: GL's operations on fragments, one function a stage, run step by step.
//!
//! It runs the same [steps](mod@crate::steps) as the GL machine, on pixels whose fragments are given as lists, and can
//! write down what became of every fragment of one of them: a table that a student can follow ([`Record`]). Algorithms
//! in [pseudocode](crate::steps::pseudo) run on the same lists ([`run_algorithm`]); those that work on lists in memory,
//! as A-buffers do, run on the lists alone ([`run_on_lists`]), or with rays cast between their fragments ([`run_on_rays`]).
//!
//! # The model
//!
//! A pixel is a list of [`Surface`]s in the order of submission. A draw sends those that it draws, one after the other,
//! through the shader's twin (`shaders`) and then through the stages in GL's order (`stages`): stencil test, depth test,
//! occlusion count, blending, masks, writing. Pixels know nothing of each other; only a query adds them up.
//!
//! Excludes: several samples per pixel, several color maps at once, scissors, dithering, logic ops, sRGB, and everything
//! before the fragment: depths and colours are given, not interpolated.

mod color;
mod depth;
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
pub use machine::{Emulator, Kind, Surface};
pub use pseudo::{AlgorithmRun, run_algorithm};
pub use record::{Draw, Fate, Outcome, Record};
