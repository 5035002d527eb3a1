//! The parts that sections 5 and 6 and the two algorithms share: maps, framebuffers, shaders, and a standard
//! compositing pass.

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

/// Front-to-back compositing on OpenGL: each surface goes under those before it. The colours are premultiplied.
pub const UNDER: Listing = Listing {
    title: "A standard compositing pass, front to back",
    source: "Carr et al. 2008, section 5.2",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "a standard compositing pass";
        glEnable(BLEND);
        glBlendFuncSeparate(ONE_MINUS_DST_ALPHA, ONE, ONE_MINUS_DST_ALPHA, ONE);
    },
};
