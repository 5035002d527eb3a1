//! Meshes and volumes that are made by rule instead of read from a file.
//!
//! Each generator is a function of its parameters. The same parameters make the same mesh, for ever. Parameters are
//! structs with defaults, so that a call names only what it changes:
//!
//! ```
//! use onionskin::generate::{Quads, quads};
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
// A table with one row of control points per line.
#[rustfmt::skip]
mod teapot_patches;
mod torus_knot;
mod tube;
mod volumes;

pub use arrows::{Arrows, arrows};
pub use cone::{Cone, cone};
pub use flow::{Flow, Seeds, runge_kutta};
pub use isosurface::{Isosurface, isosurface};
pub use order::SubmissionOrder;
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
pub(super) use volumes::{Field, bytes as bytes_of_samples, sampled};

use super::mesh::{self, Mesh};
use crate::error::{Error, Result};
use crate::fragment::Rgba;
use crate::memory::MemoryLimit;

/// The most triangles that are generated for one mesh or for one scene file: 20 million, which take some 2 GiB.
pub const MAX_TRIANGLES: u64 = 20_000_000;

/// The functions that the parameters of every generator have.
pub(super) trait Generator {
    /// Checks that every parameter and the number of triangles are in their ranges.
    fn check(&self) -> Result<(), Refusal>;

    /// The number of triangles, or an upper bound of it.
    fn triangle_count(&self) -> u64;

    /// The number of vertices, or an upper bound of it.
    fn vertex_count(&self) -> u64;

    /// The memory that the mesh will take, in bytes.
    fn bytes(&self) -> u64 {
        mesh::bytes(self.vertex_count(), self.triangle_count())
    }

    /// Whether the generator gives its meshes colours and opacities of its own.
    fn has_colors(&self) -> bool {
        false
    }

    /// The mesh. The parameters must be in their ranges.
    fn build(&self) -> Mesh;
}

/// The fault of a parameter that is out of its range.
pub(super) struct Refusal {
    /// The parameter's name.
    pub(super) key: &'static str,
    /// What is wrong with it.
    pub(super) what: String,
    /// The parameter that would be right.
    pub(super) remedy: String,
}

/// The colour of meshes whose generator has no colour of its own.
const WHITE: Rgba = Rgba::opaque([1.0; 3]);

/// An empty mesh with exactly enough room for the vertices and triangles of its generator.
fn named(name: &str, generator: &impl Generator) -> Mesh {
    let room = |count: u64| count as usize;
    Mesh {
        vertices: Vec::with_capacity(room(generator.vertex_count())),
        triangles: Vec::with_capacity(room(generator.triangle_count())),
        ..Mesh::new(name, Vec::new(), Vec::new())
    }
}

/// The mesh, or an error if a parameter is out of its range or the machine has too little memory.
fn checked(generator: &impl Generator) -> Result<Mesh> {
    let refused = |refusal: Refusal| Error::scene(refusal.what, refusal.remedy);
    generator.check().map_err(refused)?;
    let triangles = generator.triangle_count();
    MemoryLimit::of_machine()
        .check(generator.bytes())
        .map_err(|shortage| shortage.of(format!("{triangles} triangles")))?;
    Ok(generator.build())
}
