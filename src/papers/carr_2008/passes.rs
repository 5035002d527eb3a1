//! The state listings of sections 5.1 and 6, call by call.
//!
//! State persists from pass to pass: pass 2 clears to the depth that pass 1 has set, and to the stencil function of its
//! own. The paper's prose around the listings says to which range the shader clips, and where the results go; see
//! [`coherent`](super::coherent).
//!
//! The comments behind three calls are the paper's: the places of glStencilOp's arguments.

use crate::steps;
use crate::steps::{Dialect, Listing, gl::*};

/// Counts the surfaces that lower the depth; the depth becomes `D(s_n)`.
pub const PASS_1: Listing = Listing {
    title: "Pass 1: count the surfaces that update the depth",
    source: "Carr et al. 2008, section 5.1, pass 1",
    dialect: Dialect::Calls,
    steps: steps! {
        printed;
        glClearStencil(0);
        glClearDepth(1.0);
        glStencilMask(0xFF);
        glClear(DEPTH_AND_STENCIL_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glEnable(STENCIL_TEST);
        glStencilFunc(ALWAYS, 0, 0xFF);
        spelt "glStencilOp(KEEP,KEEP,INCR); ▷ fail,zfail,zpass";
        glStencilOp(KEEP, KEEP, INCR);
        drawTransparentObjects();
    },
};

/// Counts back down to 1, which takes all but the last of these surfaces. The depth becomes `z_min_prev`.
pub const PASS_2: Listing = Listing {
    title: "Pass 2: the nearest surface before s_n in the order of submission",
    source: "Carr et al. 2008, section 5.1, pass 2",
    dialect: Dialect::Calls,
    steps: steps! {
        printed;
        glClearColor(1.0, 1.0, 1.0, 1.0);
        glClear(COLOR_AND_DEPTH_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glEnable(STENCIL_TEST);
        glStencilFunc(LESS, 1, 0xFF);
        glStencilOp(KEEP, KEEP, DECR);
        drawTransparentObjects();
    },
};

/// Counts the surfaces of the unbroken run. The first surface that breaks the run inverts the stencil value.
pub const PASS_3: Listing = Listing {
    title: "Pass 3: count the surfaces that follow s_n in order",
    source: "Carr et al. 2008, section 5.1, pass 3",
    dialect: Dialect::Calls,
    steps: steps! {
        printed;
        glClearStencil(0);
        spelt "glClearDepth(0);";
        glClearDepth(0.0);
        glClear(DEPTH_AND_STENCIL_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(GREATER);
        glEnable(STENCIL_TEST);
        glStencilFunc(GREATER, 128, 0xFF);
        spelt "glStencilOp(KEEP,INVERT,INCR); ▷ fail,zfail,zpass";
        glStencilOp(KEEP, INVERT, INCR);
        drawTransparentObjects();
    },
};

/// Skips as many surfaces as pass 3 has counted. The depth becomes `z_min_post`, the nearest of the rest.
pub const PASS_4: Listing = Listing {
    title: "Pass 4: the nearest surface that interrupts the run",
    source: "Carr et al. 2008, section 5.1, pass 4",
    dialect: Dialect::Calls,
    steps: steps! {
        printed;
        glClearColor(1.0, 1.0, 1.0, 1.0);
        glClearDepth(1.0);
        glClear(COLOR_AND_DEPTH_BUFFER_BITS);
        glDepthFunc(LESS);
        glStencilFunc(EQUAL, 255, 0xFF);
        spelt "glStencilOp(INCR,KEEP,KEEP); ▷ fail,zfail,zpass";
        glStencilOp(INCR, KEEP, KEEP);
        drawTransparentObjects();
    },
};

/// Instead of passes 1 and 2: the depth becomes `D(s_n)`, the color the depth before that, `z_min_prev`.
pub const SECTION_6: Listing = Listing {
    title: "Passes 1 and 2 in one, by float blending",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        printed;
        glClearStencil(0);
        glClearDepth(1.0);
        glClearColor(1.0, 1.0, 1.0, 1.0);
        glClear(DEPTH_BUFFER_BIT);
        glClear(COLOR_AND_DEPTH_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glEnable(BLEND);
        spelt "glBlendFuncSeparate(ZERO,DEST_ALPHA,ONE,ZERO);" meaning "GL_DST_ALPHA";
        glBlendFuncSeparate(ZERO, DEST_ALPHA, ONE, ZERO);
        drawTransparentObjects();
    },
};
