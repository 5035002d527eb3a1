//! Nathan Carr, Radomír Měch and Gavin Miller, *Coherent Layer Peeling for Transparent High-Depth-Complexity Scenes*,
//! Graphics Hardware 2008.
//!
//! | in the paper | here |
//! | --- | --- |
//! | section 5, passes 1 to 4, as printed | [`passes`] |
//! | section 5, the loop around them, passes 5 and 6, for which it has prose | [`coherent`], variant A |
//! | section 6, as printed, and the loop with it | [`passes::SECTION_6`], [`coherent`], variant B |
//! | Algorithm 1, hybrid layer peeling | [`hybrid`] |
//! | Algorithm 2, the ideal GPU | [`ideal`] |
//! | layer peeling, as the paper counts it | [`hybrid::LAYER_PEELING`] |
//!
//! What the printed text gets wrong or leaves open stands beside each as amendments.
//!
//! The paper's letters: `s_c` is the last surface that was peeled, `s_n` the first behind it, `D(s)` a surface's depth.

pub mod coherent;
pub mod hybrid;
pub mod ideal;
pub mod passes;

use crate::steps;
use crate::steps::{Dialect, Listing, Map, Query, Shader, Target, gl::*};

/// The depth up to which everything has been composited.
pub const D_SC: Map = Map::named("D(sc)");
/// The depth of the first surface behind it.
pub const D_SN: Map = Map::named("D(sn)");
/// The nearest depth among the out-of-order surfaces that precede `s_n`.
pub const Z_MIN_PREV: Map = Map::named("z_min_prev");
/// The nearest depth among those that follow it.
pub const Z_MIN_POST: Map = Map::named("z_min_post");
/// The depth and stencil buffer that the passes work in.
pub const DEPTH_BUFFER: Map = Map::named("depth buffer");

/// `D(sc)`, to be written.
pub const BOUND: Target = Target("D(sc)");

/// Surfaces in (lower, upper).
pub const OPEN_OPEN: Shader = Shader("clip/open_open");
/// Surfaces in (lower, upper].
pub const OPEN_CLOSED: Shader = Shader("clip/open_closed");
/// Surfaces in [lower, upper).
pub const CLOSED_OPEN: Shader = Shader("clip/closed_open");
/// Surfaces in [lower, upper].
pub const CLOSED_CLOSED: Shader = Shader("clip/closed_closed");
/// Surfaces at the upper bound, unless that is the opaque depth.
pub const AT_BOUND: Shader = Shader("clip/at_bound");
/// Surfaces at the upper bound.
pub const AT_BOUND_AS_PRINTED: Shader = Shader("clip/at_bound_as_printed");

/// Surfaces that a compositing pass has put into the image.
pub const COMPOSITED: Query = Query("composited");

/// What front-to-back compositing is on OpenGL: each surface goes under those before it. The colours are premultiplied.
pub const UNDER: Listing = Listing {
    title: "A standard compositing pass, front to back",
    source: "Carr et al. 2008, section 5.2",
    dialect: Dialect::Calls,
    steps: steps! {
        glEnable(BLEND);
        glBlendFuncSeparate(ONE_MINUS_DST_ALPHA, ONE, ONE_MINUS_DST_ALPHA, ONE);
    },
};
