//! **onionskin**: an executable edition of four publications on correct transparency.
//!
//! What Everitt 2001, Carr, Měch and Miller 2008, Lindholm et al. 2015 and VTK's depth peeling page print as OpenGL
//! state listings and pseudocode is here data that runs: on OpenGL (headless Mesa, no display, no GPU needed) and,
//! step by step, on an emulated pixel.
//!
//! The root has the names that it takes to render scenes by published methods, and to compare the images with exact ones.
//! [`low_level`] has the modules whole. The README has a plan of them: each imports only from modules on lower floors.
//! What running the papers has shown is in [`findings`].
//!
//! # Where to begin
//!
//! | to get | see the example at |
//! | --- | --- |
//! | the exact image of triangles of your own | [`Scene`] |
//! | the colour of a pixel whose fragments you have | [`composite`] |
//! | an exact image in an OpenGL context of yours | [`Context::from_glow`] |
//! | a text of a paper by its name, printed or run | [`texts`] |
//! | a method of your own, run and counted as the papers' are | [`Technique`](low_level::methods::Technique) |
//!
//! # Features
//!
//! | feature | adds |
//! | --- | --- |
//! | `cli` (default) | the program `onionskin`, with all other features |
//! | `formats` | [`Scene::load`] and [`Animation`]: scene files, OBJ models, NRRD, NIfTI and VTK ImageData volumes |
//! | `report` | [`report`]: plots and tables |
//!
//! Without features, scenes come from code. PNG and EXR pictures are read and written all the same.

// What only a feature calls stands beside what everyone calls. With all features nothing may be unused.
#![cfg_attr(
    not(all(feature = "formats", feature = "report")),
    allow(dead_code, unused_imports)
)]

#[doc = include_str!("findings.md")]
pub mod findings {}

/// The modules whole, for those who write listings, methods or machines of their own.
///
/// What [the crate's root](crate) offers is here, too, in its module. Names here change more often than those in the root.
#[path = ""]
pub mod low_level {
    #[cfg(feature = "edition")]
    pub mod edition;
    pub mod emulator;
    pub mod error;
    pub mod fragment;
    pub mod gl;
    pub mod image;
    pub mod inspect;
    pub mod memory;
    pub mod methods;
    pub mod oracle;
    pub mod papers;
    #[cfg(feature = "report")]
    pub mod report;
    pub mod scene;
    pub mod steps;
    pub mod words;
}

// Inside of the crate, paths begin with a room.
use low_level::{
    emulator, error, fragment, gl, image, memory, methods, oracle, papers, scene, steps, words,
};

#[doc(inline)]
pub use error::{Error, Result};
#[doc(inline)]
pub use fragment::{Fragment, Rgba};
#[doc(inline)]
pub use gl::{Backend, Context, ContextOptions};
#[doc(inline)]
pub use image::{Comparison, Encoding, Image, difference_picture};
#[doc(inline)]
pub use low_level::inspect;
#[cfg(feature = "report")]
#[doc(inline)]
pub use low_level::report;
#[doc(inline)]
pub use memory::MemoryLimit;
#[doc(inline)]
pub use methods::{
    Complexity, CountBy, Entry, Frame, Layer, Method, Renderer, Stats, options, registry,
};
#[doc(inline)]
pub use oracle::composite;
#[doc(inline)]
pub use papers::{Paper, papers, texts};
#[cfg(feature = "formats")]
#[doc(inline)]
pub use scene::{Animation, LoadOptions};
#[doc(inline)]
pub use scene::{
    Camera, Mesh, Scene, Shading, Transfer, TransferPoint, Transform, Vertex, Volume, generate,
};
#[doc(inline)]
pub use steps::{Format, Text};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
