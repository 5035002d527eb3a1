//! The common stage: what the methods of all papers share.
//!
//! Every method finds the image with its background, draws the opaque geometry first, and leaves the image over it. Most
//! accumulate layers front to back in between. The maps, framebuffers and shaders for that stand here, and so do the
//! listings that count transparent fragments, unless a paper prints its own.

use crate::steps;
use crate::steps::{
    Dialect, Format, Framebuffer, Holds, Listing, Map, Query, Resources, Shader, Target, gl::*,
};

/// Opaque geometry comes first, because transparent geometry behind it is invisible. What runs it says where it comes
/// from.
pub const OPAQUE_FIRST: Listing = Listing {
    title: "Opaque geometry, colour and depth",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        run INTO_THE_IMAGE;
        glClearDepth(1.0);
        glDepthMask(true);
        glClear(COLOR_AND_DEPTH_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glUseProgram(SURFACE);
        drawOpaqueObjects();
    },
};

/// It stands apart, because no paper says it.
const INTO_THE_IMAGE: Listing = Listing {
    title: "Into the image",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "maps are drawn to through framebuffers";
        glBindFramebuffer(IMAGE);
    },
};

/// The accumulation starts transparent.
pub const CLEAR_ACCUMULATION: Listing = Listing {
    title: "Nothing composited yet",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "layers are accumulated apart from the opaque image";
        glBindFramebuffer(ACCUMULATION);
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glClear(COLOR_BUFFER_BIT);
    },
};

/// The end of accumulating front to back. The colours are premultiplied.
pub const OVER_OPAQUE: Listing = Listing {
    title: "What was composited, over the opaque image",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "what was accumulated goes over the opaque image";
        glBindFramebuffer(COMPOSITE);
        glDisable(DEPTH_TEST);
        glDisable(STENCIL_TEST);
        glColorMask(true, true, true, true);
        glEnable(BLEND);
        glBlendFunc(ONE, ONE_MINUS_SRC_ALPHA);
        glUseProgram(LAYER);
        glActiveTexture(2);
        glBindTexture(ACCUMULATED);
        drawScreen();
        glDisable(BLEND);
    },
};

/// Counts the transparent fragments before the opaque depth, all pixels together. It leaves the image as it is.
pub const COUNT: Listing = Listing {
    title: "How many fragments belong into the image",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the number of fragments that belong into the image";
        glBindFramebuffer(DEPTH_ALONE);
        glClear(DEPTH_BUFFER_BIT);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glUseProgram(SURFACE);
        drawOpaqueObjects();
        glDepthMask(false);
        glBeginQuery(FRAGMENTS);
        drawTransparentObjects();
        glEndQuery(FRAGMENTS);
        glDepthMask(true);
    },
};

/// Counts the same fragments pixel by pixel: each adds 1, which is exact up to 2^24 of them. [`OPAQUE_FIRST`] goes
/// before it.
pub const COUNT_AT_EACH_PIXEL: Listing = Listing {
    title: "The depth complexity image, by additive blending",
    source: "the common stage",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the number of fragments at each pixel";
        glBindFramebuffer(COUNTED);
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glClear(COLOR_BUFFER_BIT);
        glDepthMask(false);
        glEnable(BLEND);
        glBlendFunc(ONE, ONE);
        glUseProgram(ONE_EACH);
        drawTransparentObjects();
        glDisable(BLEND);
        glDepthMask(true);
    },
};

/// The resources that every method finds.
pub const RESOURCES: Resources = Resources {
    maps: &[(IMAGE_COLOR, Holds::Colors), (OPAQUE_DEPTH, Holds::Depths)],
    framebuffers: &[
        Framebuffer::new(IMAGE, &[IMAGE_COLOR], Some(OPAQUE_DEPTH)),
        Framebuffer::new(COMPOSITE, &[IMAGE_COLOR], None),
        Framebuffer::new(DEPTH_ALONE, &[], Some(OPAQUE_DEPTH)),
    ],
    ..Resources::NONE
};

/// The resources for accumulating layers front to back.
pub const ACCUMULATING: Resources = Resources {
    maps: &[(ACCUMULATED, Holds::Colors)],
    framebuffers: &[Framebuffer::new(ACCUMULATION, &[ACCUMULATED], None)],
    ..Resources::NONE
};

/// The resources that [`COUNT_AT_EACH_PIXEL`] needs in addition.
pub const COUNTING: Resources = Resources {
    maps: &[(COMPLEXITY, Holds::Exactly(Format::R32F))],
    framebuffers: &[Framebuffer::new(COUNTED, &[COMPLEXITY], Some(OPAQUE_DEPTH))],
    ..Resources::NONE
};

/// The finished image.
pub const IMAGE_COLOR: Map = Map::named("image");
/// The depth of the opaque geometry, or 1 where there is none.
pub const OPAQUE_DEPTH: Map = Map::named("opaque depth");
/// The layers accumulated front to back, premultiplied.
pub const ACCUMULATED: Map = Map::named("accumulated");
/// The depth complexity: a count of fragments for each pixel.
pub const COMPLEXITY: Map = Map::named("complexity");

/// The final image, with the opaque depth.
pub const IMAGE: Target = Target("image");
/// The final image alone, so that the opaque depth may be looked up while layers go into it.
pub const COMPOSITE: Target = Target("composite");
/// The framebuffer in which layers are peeled. Its depth buffer changes from peel to peel.
pub const PEEL: Target = Target("peel");
/// The framebuffer in which layers are accumulated front to back.
pub const ACCUMULATION: Target = Target("accumulation");
/// The opaque depth, and no colour.
pub const DEPTH_ALONE: Target = Target("depth alone");
/// The framebuffer in which complexity is counted, with the opaque depth.
pub const COUNTED: Target = Target("count");

/// Draws a surface.
pub const SURFACE: Shader = Shader("surface");
/// Draws a surface that lies behind the peeled layers.
pub const PEEL_SURFACE: Shader = Shader("peel");
/// Draws a map's colour (texture unit 2) as it is.
pub const LAYER: Shader = Shader("layer");
/// Draws 1 for each fragment.
pub const ONE_EACH: Shader = Shader("complexity");

/// The samples that [`COUNT`] has counted.
pub const FRAGMENTS: Query = Query("fragments");
