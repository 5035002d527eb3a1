//! Scenes made by rule instead of read from a file.
//!
//! Each generator is a function of its parameters: the same ones make the same mesh, for ever. Parameters are structs
//! with defaults, so that a call names what it changes:
//!
//! ```
//! use onionskin::scene::generate::{Quads, quads};
//!
//! let stack = quads(&Quads { count: 3, alpha: 0.25, ..Quads::default() })?;
//! assert_eq!(stack.triangle_count(), 6);
//! # Ok::<(), onionskin::Error>(())
//! ```
//!
//! In a scene file the parameters are keys of the same names, next to `generate = "quads"`. Meshes are unlit, and white
//! and opaque where the generator has no colours of its own; [`Mesh::painted`] changes that.

mod arrows;
mod cone;
mod flow;
mod grid;
mod isosurface;
mod limits;
mod order;
mod plane;
mod quads;
mod slices;
mod soup;
mod streamlines;
mod teapot;
// A table, with one row of control points to a line.
#[rustfmt::skip]
mod teapot_patches;
mod torus_knot;
mod tube;
mod volumes;

pub use arrows::{Arrows, arrows};
pub use cone::{Cone, cone};
pub use flow::{Flow, Seeds, runge_kutta};
pub use isosurface::{Isosurface, isosurface};
pub use order::Order;
pub use plane::{Plane, plane};
pub use quads::{Quads, quads};
pub use slices::{Slices, slices};
pub use soup::{Soup, soup};
pub use streamlines::{Streamlines, streamlines};
pub use teapot::{Teapot, teapot};
pub use torus_knot::{TorusKnot, torus_knot};
pub use volumes::{
    Atom, Ball, Constant, Ejection, EjectionPart, Gradient, Lattice, Potential, SheppLogan, Swirl,
    ball, constant, ejection, gradient, potential, shepp_logan, swirl,
};
pub(super) use volumes::{Field, sampled};

use super::mesh::Mesh;
use crate::error::{Error, Result};
use crate::fragment::Rgba;

/// The most triangles that are generated, in one mesh or for one scene file: 20 million, which take some 2 GiB.
pub const MAX_TRIANGLES: u64 = 20_000_000;

/// What all generators' parameters can do.
pub(super) trait Generator {
    /// Whether every parameter is in its range, the number of triangles among them.
    fn check(&self) -> Result<(), Refusal>;

    /// How many triangles it makes.
    fn triangle_count(&self) -> u64;

    /// Whether its meshes have colours and opacities of their own.
    fn has_colors(&self) -> bool {
        false
    }

    /// The mesh; only for parameters in their ranges.
    fn build(&self) -> Mesh;
}

/// A parameter out of its range.
pub(super) struct Refusal {
    /// Its name.
    pub(super) key: &'static str,
    /// What is wrong with it.
    pub(super) what: String,
    /// What to ask for instead.
    pub(super) remedy: String,
}

/// The colour of what has none of its own.
const WHITE: Rgba = Rgba::opaque([1.0; 3]);

/// A mesh to be filled.
fn named(name: &str) -> Mesh {
    Mesh::new(name, Vec::new(), Vec::new())
}

/// The mesh, if its parameters are in their ranges.
fn checked(generator: &impl Generator) -> Result<Mesh> {
    match generator.check() {
        Ok(()) => Ok(generator.build()),
        Err(refusal) => Err(Error::usage(refusal.what, refusal.remedy)),
    }
}
