//! **onionskin**: an executable edition of four publications on correct transparency.
//!
//! What Everitt 2001, Carr, Měch and Miller 2008, Lindholm et al. 2015 and VTK's depth peeling page print as OpenGL
//! state listings and pseudocode is here data that runs: on OpenGL (headless Mesa, no display, no GPU needed) and,
//! step by step, on an emulated pixel.
//!
//! The house has floors, and a room imports only from floors below it (`tests/floors.rs` holds that):
//!
//! ```text
//! 6  main.rs, cli/           one file per subcommand, thin
//! 5  report/                 pictures, plots and tables of what was counted
//! 4  methods/                one file per published method
//! 3  gl/ | emulator/         two machines that run steps: OpenGL, with all unsafe code, and one emulated pixel
//!    oracle                  sort and composite in f64; knows neither steps nor GL
//! 2  papers/                 the listings, their amendments, the claims. Pure data
//! 1  steps/                  the vocabulary: GL calls, passes, loops, queries; printing; diffing
//!    scene/                  meshes, volumes, cameras, importers, generators. No GL
//! 0  fragment, image, error  plain types
//!    memory                  how much of it may be taken
//! ```

// Tests inside of the crate use the scenes of the tests outside.
#[cfg(test)]
extern crate self as onionskin;

pub mod emulator;
pub mod error;
pub mod fragment;
pub mod gl;
pub mod image;
pub mod memory;
pub mod methods;
pub mod oracle;
pub mod papers;
pub mod report;
pub mod scene;
pub mod steps;

pub use error::{Error, Result};
pub use gl::Context;
pub use image::Image;
pub use memory::MemoryLimit;
pub use methods::{Frame, Method, Renderer};
pub use scene::Scene;
