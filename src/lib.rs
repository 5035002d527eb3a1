//! **onionskin**: an executable edition of four publications on correct transparency.
//!
//! What Everitt 2001, Carr, Měch and Miller 2008, Lindholm et al. 2015 and VTK's depth peeling page print as OpenGL
//! state listings and pseudocode is here data that runs: on OpenGL (headless Mesa, no display, no GPU needed) and,
//! step by step, on an emulated pixel.
//!
//! What running the papers has shown is in [`findings`]. The README has a plan of the modules: each imports only from
//! modules on lower floors.
//!
//! # Features
//!
//! | feature | adds |
//! | --- | --- |
//! | `cli` (default) | the program `onionskin`, with all other features |
//! | `formats` | [`Scene::load`] and [`scene::Animation`]: scene files, OBJ models, NRRD, NIfTI and VTK ImageData volumes |
//! | `report` | [`report`]: plots and tables |
//!
//! Without features, scenes come from code. PNG and EXR pictures are read and written all the same.

// What only a feature calls stands beside what everyone calls. With all features nothing may be unused.
#![cfg_attr(
    not(all(feature = "formats", feature = "report")),
    allow(dead_code, unused_imports)
)]
// Tests inside of the crate use the scenes of the tests outside.
#[cfg(test)]
extern crate self as onionskin;

pub mod emulator;
pub mod error;
#[doc = include_str!("findings.md")]
pub mod findings {}
pub mod fragment;
pub mod gl;
pub mod image;
pub mod memory;
pub mod methods;
pub mod oracle;
pub mod papers;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;
pub mod steps;

pub use error::{Error, Result};
pub use gl::Context;
pub use image::Image;
pub use memory::MemoryLimit;
pub use methods::{Frame, Method, Renderer};
pub use scene::Scene;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
