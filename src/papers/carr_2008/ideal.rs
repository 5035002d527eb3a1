//! Algorithm 2, the ideal GPU: coherent layer peeling in two geometry passes an iteration, by a rasteriser that reads
//! and writes several buffers in the order of submission.
//!
//! [`ALGORITHM_2`] is the printed pseudocode. [`IDEAL`] is what OpenGL runs where its fragment shaders can read the
//! framebuffer in order: the shaders of `glsl/ideal/` are its lines 7 to 12, 13 to 34 and 36 to 40.

use crate::papers::stage::{ACCUMULATED, OPAQUE_DEPTH, OPAQUE_FIRST, OVER_OPAQUE, PEEL};
use crate::pseudo;
use crate::steps;
use crate::steps::pseudo::{Line, Pseudocode};
use crate::steps::{
    Amendment, Dialect, Format, Framebuffer, Holds, Kind, Listing, Map, Query, Resources, Shader,
    Target, gl::*,
};

/// Algorithm 2, line by line.
pub const ALGORITHM_2: Pseudocode = Pseudocode {
    title: "Ideal Coherent Layer Peel",
    source: "Carr et al. 2008, Algorithm 2",
    lines: pseudo! {
        printed;
        for all pixel sample locations do {
            z3 <- zNear;
        }
        gChanged <- true;
        while gChanged = true do {
            spelt "gChanged ← false;";
            gChanged <- false;
            for all pixel sample locations do {
                spelt "z1 ← zOpaque;";
                z1 <- zOpaque;
                spelt "z2 ← zOpaque;";
                z2 <- zOpaque;
                spelt "zPeel ← z3;";
                zPeel <- z3;
                zPostFlag <- false;
            }
            spelt "for all geometry sample locations do ▷ Pass 1";
            for all Transparent "geometry sample locations" do {
                spelt "if (zPeel < zFragment < z2) then";
                if (zPeel < zFragment < z2) then {
                    spelt "gChanged ← true;";
                    gChanged <- true;
                    if (zFragment < z1) then {
                        z2 <- z1;
                        z1 <- zFragment;
                        spelt "z3 ← z1 ▷ Reset the state for post";
                        z3 <- z1;
                        zPostFlag <- false;
                    } else if (zPostFlag = true) then {
                        if (zFragment < z3) then {
                            z3 <- zFragment;
                        }
                    } else {
                        if (zFragment < z3) then {
                            zPostFlag <- true;
                        }
                        z3 <- zFragment;
                    }
                } else if (zFragment = zPeel) then {
                    composite;
                }
            }
            if (gChanged = true) then {
                spelt "for all geometry sample locations do ▷ Pass 2";
                for all Transparent "geometry sample locations" do {
                    spelt "if (zPeel < zFragment < z3) then";
                    if (zPeel < zFragment < z3) then {
                        composite;
                    }
                }
            }
        }
    },
};

/// The corrections of Algorithm 2.
pub const AMENDMENTS_2: [Amendment<Line>; 2] = [RESET_Z3, BEFORE_OPAQUE];

/// A pixel with nothing left keeps `z3`, hence `zPeel`, and composites its last layer again in every further iteration.
pub const RESET_Z3: Amendment<Line> = Amendment {
    key: "CX22",
    kind: Kind::Correction,
    place: "Algorithm 2, line 10",
    printed: pseudo! { zPeel <- z3; },
    amended: pseudo! {
        zPeel <- z3;
        z3 <- zOpaque;
    },
    why: "a pixel with nothing left must not stay where it is",
    test: "cx22_pixels_that_are_done_composite_their_last_layer_again",
};

/// If nothing is left, `zPeel` becomes the opaque depth.
pub const BEFORE_OPAQUE: Amendment<Line> = Amendment {
    key: "CX22",
    kind: Kind::Correction,
    place: "Algorithm 2, line 31",
    printed: pseudo! {
        if (zFragment = zPeel) then {
            composite;
        }
    },
    amended: pseudo! {
        if (zFragment = zPeel and zFragment < zOpaque) then {
            composite;
        }
    },
    why: "what lies on the opaque surface is hidden",
    test: "cx22_pixels_that_are_done_composite_their_last_layer_again",
};

/// An improvement that the printed `z2` suggests: an unbroken run ends at the loose bound `z2`, not at its own last
/// surface. It also corrects CX22.
pub const TIGHT_BOUND: [Amendment<Line>; 4] = [
    Amendment {
        key: "CX23",
        kind: Kind::Edition,
        place: "Algorithm 2, lines 1 to 3",
        printed: pseudo! { z3 <- zNear; },
        amended: pseudo! {
            z3 <- zNear;
            z2 <- zNear;
            zPostFlag <- false;
        },
        why: "what the first iteration reads",
        test: "cx23_the_tighter_bound_halves_reversed_input",
    },
    Amendment {
        key: "CX23",
        kind: Kind::Edition,
        place: "Algorithm 2, lines 8 to 10",
        printed: pseudo! {
            z1 <- zOpaque;
            z2 <- zOpaque;
            zPeel <- z3;
        },
        amended: pseudo! {
            zPeel <- z3 if zPostFlag else z2;
            z1 <- zOpaque;
            z2 <- zOpaque;
        },
        why: "the run ended where pass 2 stopped",
        test: "cx23_the_tighter_bound_halves_reversed_input",
    },
    BEFORE_OPAQUE,
    Amendment {
        key: "CX23",
        kind: Kind::Edition,
        place: "Algorithm 2, line 37",
        printed: pseudo! {
            if (zPeel < zFragment < z3) then {
                composite;
            }
        },
        amended: pseudo! {
            zEnd <- z3 if zPostFlag else z2;
            if (zPeel < zFragment < zEnd) then {
                composite;
            }
        },
        why: "an unbroken run ends at z2",
        test: "cx23_the_tighter_bound_halves_reversed_input",
    },
];

/// Algorithm 2 on OpenGL, as printed.
pub const IDEAL: Listing = Listing {
    title: "Ideal coherent layer peeling",
    source: "Carr et al. 2008, Algorithm 2",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "Algorithm 2 on an OpenGL whose shaders read the framebuffer in order";
        run OPAQUE_FIRST;
        run FROM_THE_NEAR_PLANE;
        for (i in 0..iteration_limit) {
            iterations = i + 1;
            glUseProgram(BEGIN_AS_PRINTED);
            glColorMaski(0, true, true, true, true);
            glColorMaski(1, false, false, false, false);
            glColorMaski(2, true, true, true, true);
            drawScreen();
            glUseProgram(PASS_1_AS_PRINTED);
            glColorMaski(1, true, true, true, true);
            glColorMaski(2, false, false, false, false);
            drawTransparentObjects();
            glUseProgram(CHANGED_PIXELS);
            glColorMask(false, false, false, false);
            glBeginQuery(CHANGED);
            drawScreen();
            glEndQuery(CHANGED);
            changed = samples(CHANGED);
            stop if (changed == 0) because EmptyLayer;
            glUseProgram(PASS_2_AS_PRINTED);
            glColorMaski(1, true, true, true, true);
            drawTransparentObjects();
        }
        run OVER_OPAQUE;
    },
};

/// Lines 1 to 3. The color maps are `z1`, `z2`, `z3` and the flag; the image; `zPeel`.
const FROM_THE_NEAR_PLANE: Listing = Listing {
    title: "z3 <- zNear; nothing composited yet",
    source: "Carr et al. 2008, Algorithm 2, lines 1 to 3",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(PEEL);
        glDisable(DEPTH_TEST);
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glClear(COLOR_BUFFER_BIT);
        glActiveTexture(4);
        glBindTexture(OPAQUE_DEPTH);
    },
};

/// [`AMENDMENTS_2`] on OpenGL.
pub const AMENDMENTS: [Amendment; 2] = [
    Amendment {
        key: "CX22",
        kind: Kind::Correction,
        place: "Algorithm 2, line 10",
        printed: steps! { glUseProgram(BEGIN_AS_PRINTED); },
        amended: steps! { glUseProgram(BEGIN); },
        why: "a pixel with nothing left must not stay where it is",
        test: "cx22_pixels_that_are_done_composite_their_last_layer_again",
    },
    Amendment {
        key: "CX22",
        kind: Kind::Correction,
        place: "Algorithm 2, line 31",
        printed: steps! { glUseProgram(PASS_1_AS_PRINTED); },
        amended: steps! { glUseProgram(PASS_1); },
        why: "what lies on the opaque surface is hidden",
        test: "cx22_pixels_that_are_done_composite_their_last_layer_again",
    },
];

/// [`TIGHT_BOUND`] on OpenGL.
pub const TIGHT_BOUND_ON_GL: [Amendment; 3] = [
    Amendment {
        key: "CX23",
        kind: Kind::Edition,
        place: "Algorithm 2, lines 8 to 10",
        printed: steps! { glUseProgram(BEGIN_AS_PRINTED); },
        amended: steps! { glUseProgram(BEGIN_TIGHT); },
        why: "the run ended where pass 2 stopped",
        test: "cx23_the_tighter_bound_halves_reversed_input",
    },
    AMENDMENTS[1],
    Amendment {
        key: "CX23",
        kind: Kind::Edition,
        place: "Algorithm 2, line 37",
        printed: steps! { glUseProgram(PASS_2_AS_PRINTED); },
        amended: steps! { glUseProgram(PASS_2_TIGHT); },
        why: "an unbroken run ends at z2",
        test: "cx23_the_tighter_bound_halves_reversed_input",
    },
];

/// The same by images that fragments load and store in their order, instead of a framebuffer that they fetch.
pub const BY_IMAGES: [Amendment; 3] = [
    Amendment {
        key: "images",
        kind: Kind::Edition,
        place: "Algorithm 2, lines 1 to 3",
        printed: steps! { glClear(COLOR_BUFFER_BIT); },
        amended: steps! {
            glClear(COLOR_BUFFER_BIT);
            glBindFramebuffer(NO_COLORS);
            glBindImageTexture(0, DEPTHS);
            glBindImageTexture(1, ACCUMULATED);
            glBindImageTexture(2, Z_PEEL);
            glMemoryBarrier();
        },
        why: "the maps are images",
        test: "c19_the_ideal_gpu_by_images_gives_the_same_image",
    },
    Amendment {
        key: "images",
        kind: Kind::Edition,
        place: "Algorithm 2, behind lines 7 to 12",
        printed: steps! { drawScreen(); },
        amended: steps! { drawScreen(); glMemoryBarrier(); },
        why: "a pass sees what the one before has stored",
        test: "c19_the_ideal_gpu_by_images_gives_the_same_image",
    },
    Amendment {
        key: "images",
        kind: Kind::Edition,
        place: "Algorithm 2, behind each pass",
        printed: steps! { drawTransparentObjects(); },
        amended: steps! { drawTransparentObjects(); glMemoryBarrier(); },
        why: "a pass sees what the one before has stored",
        test: "c19_the_ideal_gpu_by_images_gives_the_same_image",
    },
];

/// Draws into no color map.
const NO_COLORS: Target = Target("no colors");
/// Nothing is written to it. `GlMachine::traps` explains why it is attached.
const UNUSED_DEPTH: Map = Map::named("unused depth");

/// `z1`, `z2`, `z3` and `zPostFlag`.
pub const DEPTHS: Map = Map::named("z1 z2 z3 zPostFlag");
/// The resources that the listing takes for granted. Maps have 32-bit floats, because depths need them.
pub const RESOURCES: Resources = Resources {
    maps: &[
        (DEPTHS, Holds::Exactly(Format::Rgba32F)),
        (ACCUMULATED, Holds::Exactly(Format::Rgba32F)),
        (Z_PEEL, Holds::Exactly(Format::Rgba32F)),
    ],
    framebuffers: &[Framebuffer::new(PEEL, &[DEPTHS, ACCUMULATED, Z_PEEL], None)],
    variables: &["iteration_limit"],
    ..Resources::NONE
};

/// The shaders of [`IDEAL`], as printed and with [`AMENDMENTS`].
pub(super) const SHADERS: &[Shader] = &[
    BEGIN_AS_PRINTED,
    BEGIN,
    PASS_1_AS_PRINTED,
    PASS_1,
    PASS_2_AS_PRINTED,
    CHANGED_PIXELS,
];

/// The resources that [`BY_IMAGES`] needs in addition.
pub const NO_COLOR_RESOURCES: Resources = Resources {
    maps: &[(UNUSED_DEPTH, Holds::Exactly(Format::Depth32FStencil8))],
    framebuffers: &[Framebuffer::new(NO_COLORS, &[], Some(UNUSED_DEPTH))],
    ..Resources::NONE
};

/// The depth up to which everything has been composited.
pub const Z_PEEL: Map = Map::named("zPeel");

const BEGIN_AS_PRINTED: Shader = Shader("ideal/begin_as_printed");
const BEGIN: Shader = Shader("ideal/begin");
const BEGIN_TIGHT: Shader = Shader("ideal/begin_tight");
const PASS_1_AS_PRINTED: Shader = Shader("ideal/pass_1_as_printed");
const PASS_1: Shader = Shader("ideal/pass_1");
const PASS_2_AS_PRINTED: Shader = Shader("ideal/pass_2");
const PASS_2_TIGHT: Shader = Shader("ideal/pass_2_tight");
const CHANGED_PIXELS: Shader = Shader("ideal/changed");
/// The pixels at which pass 1 has changed a depth: `gChanged`. A query on pass 1 itself would count the surfaces that
/// it composites.
pub const CHANGED: Query = Query("gChanged");
