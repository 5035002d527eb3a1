//! This edition's own method: blending in a sorted order that the depth test proves.
//!
//! Sorting triangles on the CPU is quick, and nearly right: where it is right, one pass of blending gives the exact image.
//! Nothing in the classic painter's algorithm tells where it is wrong. Here the depth test does.
//!
//! # The proof
//!
//! It is the painter's algorithm, farthest triangles first, with three lines more. The depth buffer begins at 1 and is
//! tested with `LESS`, and what passes is written. So of the fragments of a pixel, in the order in which they are drawn,
//! each that passes lies strictly before all that have passed so far, and is blended over them. A fragment that fails
//! counts the pixel's stencil value up from 0: `INCR` stops at 255 and never goes back to 0. Hence a pixel whose stencil
//! value is 0 has had every one of its fragments blended, and each over exactly those that lie behind it. That is the exact
//! image.
//!
//! A fragment fails if it lies behind another that was drawn earlier, if it is as deep as another, or if it lies on the far
//! plane. So a pixel is marked exactly if its fragments did not come in strictly decreasing depths below 1. Nothing is
//! concluded about a marked pixel: its fragments go into a list ([`lindholm_2015`](super::lindholm_2015)), where the order
//! of submission decides between equal depths, as everywhere.
//!
//! What an opaque surface hides must not come to the depth test, for it would only fail there. The shader looks the
//! opaque depth up and discards it.
//!
//! # In pieces
//!
//! A triangle that crosses planes, such as a beam through the slices of a volume, has no place in their order: whatever it is,
//! the pixels behind the one plane or before the other one fail. So it is drawn several times, once in each slab between two
//! planes, and the shader keeps the fragments that lie in the slab. The slabs share their bounds and cover everything, so of
//! these fragments each is kept once, and the proof is the same. Where rounding puts one on the wrong side of a plane, it
//! fails.
//!
//! # Why back to front
//!
//! Front to back, with `GREATER`, proves the same. But then what is blended is not yet over the opaque image, and a draw
//! over the whole screen has to put it there: on scenes with few layers that took as long as the blending.

use super::paper::Paper;
use super::stage::{self, IMAGE_COLOR, OPAQUE_DEPTH};
use super::vtk;
use crate::papers::lindholm_2015::RESOLVED as RESOLVED_IMAGE;
use crate::steps;
use crate::steps::{
    Amendment, Dialect, Format, Framebuffer, Holds, Kind, Listing, Map, Query, Resources, Shader,
    Storage, Target, Text, gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "edition",
    citation: "onionskin, Verified painter, this edition",
    texts: &[
        (
            "verified-painter",
            Text::Listing(VERIFIED_PAINTER, &NOTHING_OPAQUE),
        ),
        ("place-resolved", Text::Listing(PLACE_RESOLVED, &[])),
        (
            "late-query",
            Text::Listing(vtk::ON_THE_FLY, &vtk::LATE_QUERY),
        ),
        ("alive", Text::Listing(vtk::ON_THE_FLY, &vtk::ALIVE)),
    ],
    resources: &[
        &stage::RESOURCES.of(&["verified-painter", "place-resolved"], &[]),
        &Resources {
            storages: &[MARKS],
            ..RESOURCES.of(&["verified-painter"], &[stage::SURFACE, BLENDED, MARKER])
        },
        &Resources {
            made: &[RESOLVED],
            storages: &[],
            ..RESOURCES.of(&["place-resolved"], &[PLACED])
        },
        &stage::RESOURCES.of(&["late-query", "alive"], &[stage::SURFACE]),
        &stage::ACCUMULATING.of(&["late-query", "alive"], &[vtk::UNDER_LAYER, stage::LAYER]),
        &Resources {
            made: &[],
            ..vtk::PEELING.of(&["late-query"], &[stage::PEEL_SURFACE])
        },
        &Resources {
            made: &[],
            ..vtk::PEELING.of(
                &["alive"],
                &[stage::PEEL_SURFACE, vtk::UNDER_FIRST, vtk::UNDER_LATER],
            )
        },
    ],
    claims: &[],
    errata: &[],
};

/// The sorted triangles over one another, and whether that was right. If the query counts no pixel, the image is finished.
pub const VERIFIED_PAINTER: Listing = Listing {
    title: "Verified painter: sorted triangles over one another, and whether that was right",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "opaque surfaces cull";
        run stage::OPAQUE_FIRST;
        edition "what lies behind the transparent surfaces, for the pixels that fail";
        glCopyImageSubData(IMAGE_COLOR, BEHIND);
        edition "the painter's algorithm, with a proof";
        run BLEND_AND_PROVE;
        edition "the pixels that failed get lists";
        run MARK;
    },
};

/// To [`VERIFIED_PAINTER`], where no surface is opaque: the background lies behind everything, and its colour is known
/// without a copy.
pub const NOTHING_OPAQUE: [Amendment; 1] = [Amendment {
    key: "nothing opaque",
    kind: Kind::Edition,
    place: "before the verified pass",
    printed: steps! { glCopyImageSubData(IMAGE_COLOR, BEHIND); },
    amended: steps! {},
    why: "the background lies behind everything",
    test: "every_bundled_scene_is_exact_by_the_verified_painter",
}];

/// To [`VERIFIED_PAINTER`], where triangles that cross planes are drawn in pieces.
pub const IN_PIECES: [Amendment; 1] = [Amendment {
    key: "in pieces",
    kind: Kind::Edition,
    place: "the verified pass",
    printed: steps! { glUseProgram(BLENDED); },
    amended: steps! { glUseProgram(BLENDED_IN_PIECES); },
    why: "a triangle that crosses planes has no place among them, but its pieces have",
    test: "triangles_that_cross_planes_are_drawn_in_pieces",
}];

/// The verified pass. The triangles come sorted back to front, as well as the CPU could.
pub const BLEND_AND_PROVE: Listing = Listing {
    title: "Back to front, each fragment before all that were blended so far",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(PROOF);
        glClearDepth(1.0);
        glClearStencil(0);
        glClear(DEPTH_AND_STENCIL_BUFFER_BITS);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glEnable(STENCIL_TEST);
        glStencilFunc(ALWAYS, 0, 0xFF);
        line "// fail, zfail, zpass";
        glStencilOp(KEEP, INCR, KEEP);
        glEnable(BLEND);
        glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA);
        glActiveTexture(5);
        glBindTexture(OPAQUE_DEPTH);
        glActiveTexture(0);
        glUseProgram(BLENDED);
        drawTransparentObjects();
        glDisable(BLEND);
    },
};

/// Notes which pixels failed, for the CPU, which numbers their lists. The depths have done their work, and are out of the way
/// of the passes that fill the lists. These draw where the stencil value is not 0.
pub const MARK: Listing = Listing {
    title: "Which pixels failed",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "a list for each pixel that failed";
        glBindFramebuffer(UNSEEN);
        glClear(DEPTH_BUFFER_BIT);
        glDepthMask(false);
        glDisable(DEPTH_TEST);
        glStencilFunc(NOTEQUAL, 0, 0xFF);
        glStencilOp(KEEP, KEEP, KEEP);
        glBindStorageBuffer(0, MARKS);
        glUseProgram(MARKER);
        glBeginQuery(FAILED);
        drawScreen();
        glEndQuery(FAILED);
        glMemoryBarrier();
    },
};

/// Where no surface is opaque, the background lies behind every list. The clear colour is still the background's.
pub const BACKGROUND_BEHIND: Listing = Listing {
    title: "The background behind every list",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(RESOLVED_IMAGE);
        glClear(COLOR_BUFFER_BIT);
    },
};

/// Where surfaces are opaque, what lies behind each list.
pub const OPAQUE_BEHIND: Listing = Listing {
    title: "What lies behind the transparent surfaces, list by list",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(UNSEEN);
        glDisable(DEPTH_TEST);
        glActiveTexture(3);
        glBindTexture(BEHIND);
        glActiveTexture(0);
        glBindImageTexture(0, RESOLVED);
        glUseProgram(BEHIND_LISTS);
        drawScreen();
        glMemoryBarrier();
    },
};

/// Puts the marked pixels in their places.
pub const PLACE_RESOLVED: Listing = Listing {
    title: "The pixels that failed, as their lists were resolved",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the image is whole";
        glBindFramebuffer(PROOF);
        glEnable(STENCIL_TEST);
        glDisable(DEPTH_TEST);
        glDepthMask(false);
        glActiveTexture(3);
        glBindTexture(RESOLVED);
        glActiveTexture(0);
        glUseProgram(PLACED);
        drawScreen();
        glDisable(STENCIL_TEST);
    },
};

/// What the listings take for granted.
pub const RESOURCES: Resources = Resources {
    maps: &[(PROOF_DEPTH, Holds::Exactly(Format::Depth32FStencil8))],
    made: &[BEHIND],
    framebuffers: &[
        Framebuffer::new(PROOF, &[IMAGE_COLOR], Some(PROOF_DEPTH)),
        Framebuffer::new(UNSEEN, &[], Some(PROOF_DEPTH)),
    ],
    storages: &[MARKS],
    ..Resources::NONE
};

/// The depth of the last fragment that was blended, and in its stencil how many failed.
///
/// It is a float, because a depth that is stored as it was compared is what the proof rests on. With 24 bits llvmpipe takes 3
/// to 5 % less time, but it compares before it rounds: behind a depth that was rounded down there would be room for a nearer
/// one.
pub const PROOF_DEPTH: Map = Map::named("proof");
/// The pixels that failed, side by side in as few rows as they fill: first what lies behind their transparent surfaces, then
/// the result.
pub const RESOLVED: Map = Map::named("resolved");
/// The opaque image.
pub const BEHIND: Map = Map::named("behind");
/// Which pixels failed: a bit for each, in words of 32 pixels of a row, row by row from the bottom.
pub const MARKS: Storage = Storage("marks");
/// From where and up to where the pieces of triangles reach.
pub const BOUNDS: Storage = Storage("bounds of pieces");
/// The pixels that failed.
pub const FAILED: Query = Query("failed");

const PROOF: Target = Target("proof");
const UNSEEN: Target = Target("nothing but marks");
const BLENDED: Shader = Shader("verified/surface");
const BLENDED_IN_PIECES: Shader = Shader("verified/pieces");
const MARKER: Shader = Shader("verified/mark");
const BEHIND_LISTS: Shader = Shader("verified/behind");
const PLACED: Shader = Shader("verified/place");
