//! The depth complexity image (section 3.1), and the ways to count it.

use super::names::COUNT_ATOMICALLY;
use crate::papers::stage::{COMPLEXITY, COUNTED, ONE_EACH};
use crate::steps;
use crate::steps::{Dialect, Listing, gl::*};

/// The depth complexity image: "all geometries are rendered into an integer image; the pixels of this image act as atomic
/// counters". Shading and blending are disabled.
pub const COMPLEXITY_IMAGE: Listing = Listing {
    title: "The depth complexity image, by one atomic counter a pixel",
    source: "Lindholm et al. 2015, section 3.1",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the counters begin at 0; the shader finds them as image 0; depths stay as they are";
        glBindFramebuffer(COUNTED);
        glClearBufferuiv(0);
        glBindImageTexture(0, COMPLEXITY);
        glDepthMask(false);
        prose "when rendering the complexity image, both shading and blending are disabled";
        glColorMask(false, false, false, false);
        glDisable(BLEND);
        prose "all geometries and volume bounding boxes are rendered into an integer image ... the pixels of this image act as atomic counters and are incremented by the incoming fragments";
        glUseProgram(COUNT_ATOMICALLY);
        drawTransparentObjects();
        edition "the counts can be read, and the rest is as it was before";
        glMemoryBarrier();
        glColorMask(true, true, true, true);
        glDepthMask(true);
    },
};

/// The same with all geometry, as the paper has it: no word is said of opaque surfaces and of what they hide.
pub const COMPLEXITY_OF_ALL: Listing = Listing {
    title: "The depth complexity image of all geometry",
    source: "Lindholm et al. 2015, section 3.1",
    dialect: Dialect::Calls,
    steps: steps! {
        glDisable(DEPTH_TEST);
        run COMPLEXITY_IMAGE;
        glBindFramebuffer(COUNTED);
        glColorMask(false, false, false, false);
        glDepthMask(false);
        glDisable(DEPTH_TEST);
        drawOpaqueObjects();
        glMemoryBarrier();
        glColorMask(true, true, true, true);
        glDepthMask(true);
    },
};

/// The same count by the stencil buffer: at most 255.
pub const COUNT_BY_STENCIL: Listing = Listing {
    title: "The depth complexity image, by the stencil buffer",
    source: "Lindholm et al. 2015, section 6.2",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the counts begin at 0; colours and depths stay as they are";
        glBindFramebuffer(COUNTED);
        glClearStencil(0);
        glClear(STENCIL_BUFFER_BIT);
        glColorMask(false, false, false, false);
        glDepthMask(false);
        prose "the ppAO component is implemented using an 8bit stencil buffer";
        glEnable(STENCIL_TEST);
        glStencilFunc(ALWAYS, 0, 0xFF);
        glStencilOp(KEEP, KEEP, INCR);
        glUseProgram(ONE_EACH);
        drawTransparentObjects();
        edition "as it was before";
        glDisable(STENCIL_TEST);
        glColorMask(true, true, true, true);
        glDepthMask(true);
    },
};
