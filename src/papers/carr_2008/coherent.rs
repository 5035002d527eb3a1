//! Coherent layer peeling on a GPU: the loop of section 5 (variant A), and with section 6's pass (variant B).
//!
//! Each iteration finds, at every pixel, the run of surfaces behind `D(sc)` that were submitted in the right order
//! already, composites the run, and moves `D(sc)` to its end:
//!
//! ```text
//! passes 1, 2   (D(sc), opaque)                 D(sn); the nearest surface submitted before s_n:  z_min_prev
//! passes 3, 4   [D(sn), min(z_min_prev, opaque))  the nearest that interrupts the run after s_n:  z_min_post
//! passes 5, 6   [D(sn), U) in order, then U,    U = min(z_min_prev, z_min_post, opaque)
//! ```
//!
//! The paper prints the passes ([`super::passes`]) and describes in prose the ranges that a fragment shader clips to,
//! the compositing passes 5 and 6, the maps, and the end of the loop. The prose is written out here as it stands. Where
//! it is wrong or silent, [`AMENDMENTS`] correct or complete it. Improvements that the paper only points at stand
//! beside them.

mod amendments;
mod loops;

pub use amendments::*;
pub use loops::*;
