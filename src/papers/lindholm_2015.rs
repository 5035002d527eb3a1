//! Lindholm, Falk, Sundén, Ynnerman, Ropinski, *Hybrid Data Visualization Based on Depth Complexity Histogram
//! Analysis*, Computer Graphics Forum 34(1), 2015.
//!
//! The paper gives the A-buffer as a figure of three steps (figure 3), ppAO and ppDP as pseudocode (section 5), and the
//! masking of ppAO as a paragraph (section 6.2). The pseudocode is in [`components`], where the emulator runs it on
//! lists. The calls that the CPU makes to OpenGL stand here as listings. ppDP runs inside of a shader,
//! `glsl/a_buffer/pp_dp.glsl`, whose lines are the pseudocode's.

mod claims;
mod complexity;
pub mod components;
mod errata;
pub mod fused;
mod names;
mod resolve;

pub use complexity::{COMPLEXITY_IMAGE, COMPLEXITY_OF_ALL, COUNT_BY_STENCIL};
pub use names::{
    ANCHOR, CLEARED, COST, COUNTER, COVERED, FILL, NEXT, OFFSETS, POOL, RAY_ENDS, RECORDS, RESOLVED,
};
pub use resolve::{BY_COUNTER, LAST_TAKES_THE_REST, MARKED, NO_STENCIL, PP_AO, RESOLVE, RESOLVING};

use names::{
    BEGIN, COUNT_ATOMICALLY, FILL_ATOMICALLY, FILL_IN_ORDER, RESOLVE_ALL, RESOLVE_SEGMENT,
    RESOLVE_SEGMENT_OR_REST,
};

use super::paper::Paper;
use super::stage::{self, OPAQUE_DEPTH};
use crate::steps;
use crate::steps::pseudo::Pseudocode;
use crate::steps::{
    Amendment, Dialect, Format, Framebuffer, Holds, Kind, Listing, Resources, Text, gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "lindholm",
    citation: "Stefan Lindholm, Martin Falk, Erik Sundén, Anders Ynnerman, Timo Ropinski, Hybrid Data Visualization \
               Based on Depth Complexity Histogram Analysis, Computer Graphics Forum 2015",
    texts: &[
        ("complexity-image", Text::Listing(COMPLEXITY_IMAGE, &[])),
        (
            "clear-and-fill",
            Text::Listing(CLEAR_AND_FILL, &[BEGIN_AT_OFFSETS, ORDERED]),
        ),
        ("resolve", Text::Listing(RESOLVE, &[])),
        (
            "fill-for-pp-ao",
            Text::Listing(FILL_FOR_PP_AO, &[COUNTED_ALREADY, COUNT_INTO_STENCIL]),
        ),
        (
            "pp-ao",
            Text::Listing(PP_AO, &[BY_COUNTER, NO_STENCIL, MARKED]),
        ),
        ("section-4", Text::Lists(components::STATIC_ARRAY, &[])),
        (
            "section-4-nearest",
            Text::Lists(
                Pseudocode {
                    title: "Static Local Array that keeps the nearest",
                    ..components::STATIC_ARRAY
                },
                &[components::KEEP_NEAREST],
            ),
        ),
        (
            "section-5.1",
            Text::Lists(components::PP_AO, &[components::PP_AO_AMENDMENT]),
        ),
        (
            "section-5.2",
            Text::Lists(components::PP_DP, &components::PP_DP_AMENDMENTS),
        ),
        (
            "section-6.1",
            Text::Lists(fused::FUSED, &fused::FUSED_AMENDMENTS),
        ),
        (
            "section-6.1-pp-dp",
            Text::Lists(fused::PP_DP_ON_RAYS, &fused::FUSED_PP_DP),
        ),
    ],
    resources: &[
        &stage::COUNTING.of(&["complexity-image"], &[COUNT_ATOMICALLY]),
        &FILLING.of(&["clear-and-fill", "fill-for-pp-ao"], &[FILL_ATOMICALLY]),
        &Resources::NONE.of(&["clear-and-fill"], &[BEGIN, FILL_IN_ORDER]),
        &RESOLVING.of(&["resolve", "pp-ao"], &[RESOLVE_ALL]),
        &Resources {
            variables: &["N"],
            ..Resources::NONE.of(&["resolve"], &[])
        },
        &Resources {
            variables: &["num_segments"],
            ..Resources::NONE.of(&["pp-ao"], &[RESOLVE_SEGMENT, RESOLVE_SEGMENT_OR_REST])
        },
    ],
    claims: claims::CLAIMS,
    errata: errata::ERRATA,
};

/// Nothing has been resolved yet.
pub const CLEAR_COST: Listing = Listing {
    title: "What the Resolve Step has cost so far",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "what the Resolve Step costs is counted";
        glBindFramebuffer(RESOLVED);
        glClearBufferuiv(1);
    },
};

/// The A-buffer's first two steps (figure 3).
pub const CLEAR_AND_FILL: Listing = Listing {
    title: "Clear Step and Fill Step",
    source: "Lindholm et al. 2015, figure 3",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "three sequential steps as illustrated in Figure 3: the Clear Step, the Fill Step, and the Resolve Step";
        line "// Clear Step";
        edition "maps are written through framebuffers";
        glBindFramebuffer(CLEARED);
        prose "three sequential steps as illustrated in Figure 3: the Clear Step, the Fill Step, and the Resolve Step";
        glClearBufferuiv(0);
        glClearBufferuiv(1);
        prose "capture and store a list of rasterized fragments on a per-pixel basis (called Fragment List)";
        line "// Fill Step: fill fragment list";
        edition "where the shader finds counters, lists and pool; opaque surfaces cull, and colours and depths stay as they are";
        glBindFramebuffer(FILL);
        glDepthMask(false);
        glBindImageTexture(0, COUNTER);
        glBindImageTexture(1, ANCHOR);
        glBindStorageBuffer(0, RECORDS);
        glBindStorageBuffer(1, NEXT);
        glBindStorageBuffer(2, OFFSETS);
        glBindStorageBuffer(3, POOL);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glColorMask(false, false, false, false);
        prose "capture and store a list of rasterized fragments on a per-pixel basis (called Fragment List)";
        glUseProgram(FILL_ATOMICALLY);
        drawTransparentObjects();
        edition "the lists can be read, and the rest is as it was before";
        glMemoryBarrier();
        glColorMask(true, true, true, true);
    },
};

/// With framebuffer fetch the counters are colours of the framebuffer, and fragments take their turns.
pub const ORDERED: Amendment = Amendment {
    key: "L04",
    kind: Kind::Edition,
    place: "figure 3, Fill Step",
    printed: steps! {
        glColorMask(false, false, false, false);
        glUseProgram(FILL_ATOMICALLY);
    },
    amended: steps! { glUseProgram(FILL_IN_ORDER); },
    why: "ordered fragments need no atomics",
    test: "l04_every_manager_and_fill_gives_the_oracle_s_image",
};

/// With base offsets, a pixel's counter begins at the pixel's offset. The depth test is enabled again before the Fill
/// Step.
pub const BEGIN_AT_OFFSETS: Amendment = Amendment {
    key: "L05",
    kind: Kind::Prose("the explicit pointer holds a base offset into the pool"),
    place: "figure 3, Clear Step",
    printed: steps! { glClearBufferuiv(0); },
    amended: steps! {
        edition "the draw reaches every pixel";
        glDisable(DEPTH_TEST);
        prose "the explicit pointer holds a base offset into the pool";
        glBindStorageBuffer(2, OFFSETS);
        edition "the counter begins there";
        glUseProgram(BEGIN);
        drawScreen();
    },
    why: "the counter then says where the next record goes, and no fragment looks up its pixel's offset",
    test: "l05_base_offsets_keep_every_pixel_s_list_to_itself",
};

/// To every listing here that draws the transparent objects, where the scene has volumes: "for volumetric sources, only
/// the associated proxy geometry is rendered during the Fill Step". The list tells whether a ray is inside of a volume,
/// so it must hold all of a proxy's fragments: those behind opaque surfaces (no depth test), and those before the near
/// plane and behind the far one (depths are clamped, and nothing is clipped).
pub const PROXIES: Amendment = Amendment {
    key: "L16",
    kind: Kind::Prose("only the associated proxy geometry is rendered during the Fill Step"),
    place: "section 6.1, Fill Step",
    printed: steps! { drawTransparentObjects(); },
    amended: steps! {
        drawTransparentObjects();
        edition "a list has all faces of a box, wherever they lie";
        glDisable(DEPTH_TEST);
        glEnable(DEPTH_CLAMP);
        prose "only the associated proxy geometry is rendered during the Fill Step";
        drawProxies();
        edition "as it was before";
        glDisable(DEPTH_CLAMP);
        glEnable(DEPTH_TEST);
    },
    why: "volumes enter the lists as the boxes around them",
    test: "l16_fog_and_a_pane_follow_the_closed_form",
};

/// This goes before the Resolve Step if the scene has volumes, because the opaque surfaces end the rays.
pub const OPAQUE_ENDS_RAYS: Listing = Listing {
    title: "Where rays end at the latest",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "opaque surfaces end rays";
        glCopyImageSubData(OPAQUE_DEPTH, RAY_ENDS);
        glActiveTexture(5);
        glBindTexture(RAY_ENDS);
        glActiveTexture(0);
    },
};

/// The Fill Step before [`PP_AO`]. Section 5.1 counts in an integer buffer, which is the fill's own counter. The stencil
/// buffer of section 6.2 is another one.
pub const FILL_FOR_PP_AO: Listing = Listing {
    title: "Clear Step and Fill Step before ppAO",
    source: "Lindholm et al. 2015, figure 3 and sections 5.1 and 6.2",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the stencil buffer of section 6.2 begins with nothing counted, and with the operations that OpenGL has at first";
        glBindFramebuffer(FILL);
        glClearStencil(0);
        glClear(STENCIL_BUFFER_BIT);
        glStencilOp(KEEP, KEEP, KEEP);
        run CLEAR_AND_FILL;
    },
};

/// To [`FILL_FOR_PP_AO`]: how the counts come into the stencil buffer, which holds up to 255.
pub const COUNT_INTO_STENCIL: Amendment = Amendment {
    key: "LX16",
    kind: Kind::Filling(COUNTS_ALONG),
    place: "sections 5.1 and 6.2, how the counts come into the stencil buffer",
    printed: steps! { run CLEAR_AND_FILL; },
    amended: steps! { run CLEAR_AND_FILL amended by &[COUNT_WHILE_FILLING]; },
    why: "the stencil buffer that masks has to hold the counts",
    test: "lx16_literally_the_stencil_buffer_holds_no_count_and_masks_nothing",
};

/// To [`CLEAR_AND_FILL`], in [`COUNT_INTO_STENCIL`]. The stencil function is OpenGL's at first, and in a later band the last
/// segment's: it lets every count pass that belongs to a segment. What comes after sets its own operation.
pub const COUNT_WHILE_FILLING: Amendment = Amendment {
    key: "LX16",
    kind: Kind::Filling(COUNTS_ALONG),
    place: "section 5.1, Fill Step",
    printed: steps! { drawTransparentObjects(); },
    amended: steps! {
        glEnable(STENCIL_TEST);
        glStencilOp(KEEP, KEEP, INCR);
        drawTransparentObjects();
    },
    why: "the stencil buffer counts along",
    test: "lx16_literally_the_stencil_buffer_holds_no_count_and_masks_nothing",
};

const COUNTS_ALONG: &str =
    "Section 5.1: \"The counting can be combined with the scene rasterization in the Fill Step\"";

/// To [`FILL_FOR_PP_AO`], with [`BY_COUNTER`].
pub const COUNTED_ALREADY: Amendment = Amendment {
    key: "LX06",
    kind: Kind::Correction,
    place: "section 6.2, 8bit stencil buffer",
    printed: steps! {
        glBindFramebuffer(FILL);
        glClearStencil(0);
        glClear(STENCIL_BUFFER_BIT);
        glStencilOp(KEEP, KEEP, KEEP);
        run CLEAR_AND_FILL;
    },
    amended: steps! { run CLEAR_AND_FILL; },
    why: "the fill's own counter is the integer buffer of section 5.1",
    test: "l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost",
};

/// [`FILL_FOR_PP_AO`] as it runs as printed. It is a listing of its own, so that amendments from outside, such as
/// [`PROXIES`], find the steps that count.
pub const CLEAR_AND_COUNTING_FILL: Listing = Listing {
    title: "Clear Step, and Fill Step that counts along",
    source: "Lindholm et al. 2015, figure 3 and section 5.1",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the Fill Step before ppAO";
        run FILL_FOR_PP_AO amended by &[COUNT_INTO_STENCIL];
    },
};

/// What the Clear Step and the Fill Step take for granted if lists are filled by atomics. Other fills attach other maps,
/// because an attachment costs time.
pub const FILLING: Resources = Resources {
    maps: &[
        (COUNTER, Holds::Exactly(Format::R32Ui)),
        (ANCHOR, Holds::Exactly(Format::R32Ui)),
    ],
    framebuffers: &[
        Framebuffer::new(CLEARED, &[COUNTER, ANCHOR], Some(OPAQUE_DEPTH)),
        Framebuffer::new(FILL, &[], Some(OPAQUE_DEPTH)),
    ],
    storages: &[RECORDS, NEXT, OFFSETS, POOL],
    ..Resources::NONE
};
