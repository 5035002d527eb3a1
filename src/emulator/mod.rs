//! The emulated pixel: GL's operations on fragments, with one function per stage, run step by step.
//!
//! It runs the same [steps](mod@crate::steps) as the GL machine, on pixels whose fragments are given as lists. It can
//! record what happens to every fragment of its pixels, as tables that a student can follow ([`Record`]). Algorithms in
//! [pseudocode](crate::steps::pseudo) run on the same lists ([`run_algorithm`]). Algorithms on lists in memory, as
//! A-buffers have them, run on the lists alone ([`run_on_lists`]), or with rays cast between the fragments
//! ([`run_on_rays`]). Both can be followed line by line ([`follow_algorithm`], [`follow_on_lists`]).
//!
//! # The model
//!
//! A pixel is a list of [`Surface`]s in the order of submission. A draw sends its surfaces, one after the other,
//! through the shader's twin (in `shaders`) and then through the stages in GL's order (`stages`): stencil test, depth
//! test, occlusion count, blending, masks, writing. Shaders that ask for early tests come after the tests. Pixels are
//! independent of each other; only a query adds them up.
//!
//! What pixels share on OpenGL is here each pixel's own: a pixel's fragment list is its records in their order
//! ([`Emulator::list`]), its base offset is 0, and its nodes are numbered from 0. So counters and anchors say what OpenGL's
//! say less the pixel's offset. Lists of marked pixels, which OpenGL has side by side in maps of their own, are at the
//! pixels themselves.
//!
//! Excludes: several samples per pixel, scissors but for bands and parts of the screen, dithering, logic ops, sRGB, classic
//! calls, the invariance experiment, triangles in pieces, uniforms, and everything before the fragment: depths and colours are given, not
//! interpolated. A shader that asks how far a fragment is away has that computed from its depth. Rays through volumes are
//! sampled in f64; early ray termination does not end them, and a Local Array that keeps the nearest fragments does not
//! know of volumes whose boxes it has dropped.

mod color;
mod depth;
mod draw;
mod held;
mod invocation;
mod lists;
mod machine;
mod maps;
mod perform;
mod place;
mod pseudo;
mod record;
mod scan;
mod settings;
mod shaders;
mod stages;
mod state;
mod surface;

pub use color::Texel;
pub use lists::{
    ExecutedListLine, ListRun, ListState, RayEvent, RayHappening, RayRun, RayScene, RayVolume,
    Resolved, Subpass, follow_on_lists, run_on_lists, run_on_rays,
};
pub use machine::Emulator;
pub use pseudo::{AlgorithmRun, ExecutedLine, follow_algorithm, run_algorithm};
pub use record::{Draw, Fate, FragmentOutcome, InList, Record, Resolve};
pub use scan::prefix_scan;
pub use settings::PixelRay;
pub use surface::{Group, Surface};
