//! The Resolve Step: with one program for all pixels, and by ppAO with one for each complexity segment.

use super::names::{
    ANCHOR, COST, COUNTER, COVERED, RESOLVE_ALL, RESOLVE_SEGMENT, RESOLVE_SEGMENT_OR_REST, RESOLVED,
};
use crate::papers::stage::{IMAGE_COLOR, OPAQUE_DEPTH};
use crate::steps;
use crate::steps::{
    Amendment, Dialect, Format, Framebuffer, Holds, Kind, Listing, Resources, gl::*,
};

/// The Resolve Step with one program for all pixels.
pub const RESOLVE: Listing = Listing {
    title: "Resolve Step with a Local Array of N",
    source: "Lindholm et al. 2015, figure 3",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "what the Resolve Step reads and writes";
        run BEFORE_RESOLVE;
        prose "the prevalent approach ... is to allocate a fixed sized array, of size N per thread";
        glUseProgramOfSize(RESOLVE_ALL, "N");
        drawScreen();
        edition "as it was before";
        run AFTER_RESOLVE;
    },
};

/// ppAO (section 5.1), masked by the stencil buffer as section 6.2 has it: "different segments are triggered by
/// modifying the OpenGL stencil function".
pub const PP_AO: Listing = Listing {
    title: "per-pixel Array Optimization: a resolve program for each complexity segment",
    source: "Lindholm et al. 2015, sections 5.1 and 6.2",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "what the Resolve Step reads and writes";
        run BEFORE_RESOLVE;
        prose "the ppAO component is implemented using an 8bit stencil buffer for masking the different complexity segments";
        glEnable(STENCIL_TEST);
        edition "the resolved pixels are counted";
        glBeginQuery(COVERED);
        prose "enclosed in a loop on the CPU, where different segments are triggered by modifying the OpenGL stencil function";
        i = 8;
        for (segment in 0..num_segments) {
            glUseProgramOfSize(RESOLVE_ALL, "i");
            glStencilReference(GEQUAL, "i", 0xFF);
            drawScreen();
            i = i * 2;
        }
        edition "the resolved pixels are counted";
        glEndQuery(COVERED);
        edition "as it was before";
        glDisable(STENCIL_TEST);
        run AFTER_RESOLVE;
    },
};

/// Erratum LX07. Of all stencil operations, INVERT goes furthest.
pub const MARKED: Amendment = Amendment {
    key: "LX07",
    kind: Kind::Filling("Section 5.1: the comment \"mark pixel as resolved\""),
    place: "sections 5.1 and 6.2, how a pixel is marked as resolved",
    printed: steps! { glEnable(STENCIL_TEST); },
    amended: steps! {
        glEnable(STENCIL_TEST);
        glStencilOp(KEEP, KEEP, INVERT);
    },
    why: "a resolved pixel must not pass the next segment's test",
    test: "l11_of_the_marks_only_invert_works_and_only_up_to_128",
};

/// To [`PP_AO`]: erratum LX06, with LX05 inside of it. A pixel belongs to one segment by its own count, which has 32 bits.
pub const BY_COUNTER: Amendment = Amendment {
    key: "LX06",
    kind: Kind::Correction,
    place: "section 5.1, if depth complexity(p) <= i, and section 6.2, 8bit stencil buffer",
    printed: steps! {
        glUseProgramOfSize(RESOLVE_ALL, "i");
        glStencilReference(GEQUAL, "i", 0xFF);
    },
    amended: steps! { run BY_COUNTER_ALONE amended by &[LAST_TAKES_THE_REST]; },
    why: "an integer counter is compared: previous segment < count <= i",
    test: "l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost",
};

/// [`BY_COUNTER`] without LX05.
const BY_COUNTER_ALONE: Listing = Listing {
    title: "The pixels of a segment, by their counts",
    source: "Lindholm et al. 2015, section 5.1",
    dialect: Dialect::Calls,
    steps: steps! { glUseProgramOfSize(RESOLVE_SEGMENT, "i"); },
};

/// Erratum LX05, to what [`BY_COUNTER`] runs. The last segment takes every pixel that is left.
pub const LAST_TAKES_THE_REST: Amendment = Amendment {
    key: "LX05",
    kind: Kind::Correction,
    place: "section 5.1, if depth complexity(p) <= i",
    printed: steps! { glUseProgramOfSize(RESOLVE_SEGMENT, "i"); },
    amended: steps! { glUseProgramOfSize(RESOLVE_SEGMENT_OR_REST, "i"); },
    why: "what no segment holds is the last one's",
    test: "lx05_by_counter_alone_exactly_what_lies_past_the_last_segment_is_lost",
};

/// Goes with [`BY_COUNTER`], after which the stencil test has nothing to do.
pub const NO_STENCIL: Amendment = Amendment {
    key: "LX07",
    kind: Kind::Edition,
    place: "section 6.2, stencil masking",
    printed: steps! { glEnable(STENCIL_TEST); },
    amended: steps! {},
    why: "no pixel is in two segments, so none has to be marked",
    test: "lx07_as_printed_pixels_are_resolved_twice",
};

const BEFORE_RESOLVE: Listing = Listing {
    title: "What the Resolve Step reads and writes",
    source: "Lindholm et al. 2015, figure 3",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(RESOLVED);
        glDisable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendFunc(ONE, ONE_MINUS_SRC_ALPHA);
        glActiveTexture(1);
        glBindTexture(COUNTER);
        glActiveTexture(2);
        glBindTexture(ANCHOR);
        glActiveTexture(0);
    },
};

const AFTER_RESOLVE: Listing = Listing {
    title: "As it was before",
    source: "Lindholm et al. 2015, figure 3",
    dialect: Dialect::Calls,
    steps: steps! {
        glDisable(BLEND);
        glDepthMask(true);
    },
};

/// What the Resolve Step takes for granted besides its variables.
pub const RESOLVING: Resources = Resources {
    maps: &[
        (COUNTER, Holds::Exactly(Format::R32Ui)),
        (ANCHOR, Holds::Exactly(Format::R32Ui)),
        (COST, Holds::Exactly(Format::Rgba32Ui)),
    ],
    framebuffers: &[Framebuffer::new(
        RESOLVED,
        &[IMAGE_COLOR, COST],
        Some(OPAQUE_DEPTH),
    )],
    ..Resources::NONE
};
