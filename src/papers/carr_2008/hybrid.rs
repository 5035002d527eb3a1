//! Algorithm 1, hybrid layer peeling, and layer peeling, which is the same without sorted geometry.
//!
//! [`ALGORITHM_1`] is the printed pseudocode. [`HYBRID`] is what OpenGL runs: each `for all ... geometry` is a geometry
//! pass, each `if` a depth test or a fragment shader that clips, `gChanged` an occlusion query.

use super::shared::*;
use crate::papers::stage::{
    self, ACCUMULATION, CLEAR_ACCUMULATION, OPAQUE_DEPTH, OPAQUE_FIRST, OVER_OPAQUE, PEEL,
};
use crate::pseudo;
use crate::steps;
use crate::steps::pseudo::{Line, Pseudocode};
use crate::steps::{
    Amendment, Dialect, Framebuffer, Holds, Kind, Listing, Map, Query, Resources, Shader, gl::*,
};

/// Algorithm 1, line by line.
pub const ALGORITHM_1: Pseudocode = Pseudocode {
    title: "Hybrid Layer Peeling",
    source: "Carr et al. 2008, Algorithm 1",
    lines: pseudo! {
        printed;
        for all pixel sample locations do {
            zPeel <- zNear;
        }
        gChanged <- true;
        while gChanged = true do {
            gChanged <- false;
            for all pixel sample locations do {
                zPeelNext <- zOpaque;
            }
            for all Unsorted "unsorted geometry fragment locations" do {
                if (zPeel < zFragment < zPeelNext) then {
                    zPeelNext <- zFragment;
                    spelt "gChanged ← true ▷ occlusion query";
                    gChanged <- true;
                }
            }
            for all Sorted "sorted geometry fragment locations" do {
                if (zPeel < zFragment < zPeelNext) then {
                    composite;
                }
            }
            if (gChanged = true) then {
                for all Unsorted "non-sorted geometry fragments" do {
                    if (zFragment = zPeelNext) then {
                        composite;
                    }
                }
                swap(zPeel, zPeelNext);
            }
        }
    },
};

/// The corrections of Algorithm 1.
pub const AMENDMENTS_1: [Amendment<Line>; 3] = [
    Amendment {
        key: "CX21",
        kind: Kind::Correction,
        place: "Algorithm 1, line 2",
        printed: pseudo! { zPeel <- zNear; },
        amended: pseudo! { zPeel <- before zNear; },
        why: "what lies on the near plane is peeled too",
        test: "cx21_unsorted_surfaces_on_the_near_plane_are_lost",
    },
    Amendment {
        key: "CX19",
        kind: Kind::Correction,
        place: "Algorithm 1, line 17",
        printed: pseudo! {
            if (zPeel < zFragment < zPeelNext) then {
                composite;
            }
        },
        amended: pseudo! {
            if (zPeel <= zFragment < zPeelNext) then {
                composite;
            }
        },
        why: "sorted surfaces at a peel's depth come right behind the unsorted ones",
        test: "cx19_sorted_surfaces_at_a_peel_depth_are_lost",
    },
    Amendment {
        key: "CX20",
        kind: Kind::Correction,
        place: "Algorithm 1, line 23",
        printed: pseudo! {
            if (zFragment = zPeelNext) then {
                composite;
            }
        },
        amended: pseudo! {
            if (zFragment = zPeelNext and zFragment < zOpaque) then {
                composite;
            }
        },
        why: "what lies on the opaque surface is hidden",
        test: "cx20_unsorted_surfaces_on_the_opaque_surface_are_composited_in_every_iteration",
    },
];

/// Algorithm 1 on OpenGL, as printed.
pub const HYBRID: Listing = Listing {
    title: "Hybrid layer peeling",
    source: "Carr et al. 2008, Algorithm 1",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "Algorithm 1 in calls of OpenGL: each for over geometry is a pass, each if a depth test or a clip";
        run OPAQUE_FIRST;
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        composited = 0;
        for (i in 0..iteration_limit) {
            iterations = i + 1;
            run BEGIN_PEEL;
            glBeginQuery(CHANGED);
            drawUnsortedObjects();
            glEndQuery(CHANGED);
            run BEGIN_COMPOSITING;
            run SORTED_IN_RANGE;
            changed = samples(CHANGED);
            if (changed > 0) {
                run UNSORTED_AT_PEEL;
                drawUnsortedObjects();
                glEndQuery(COMPOSITED);
                composited = composited + samples(COMPOSITED);
                swap(Z_PEEL, Z_PEEL_NEXT);
            }
            composited = composited + samples(BETWEEN);
            stop if (changed == 0) because EmptyLayer;
        }
        run OVER_OPAQUE;
    },
};

/// Layer peeling as the paper counts it: one geometry pass finds the next depth, and one composites the surfaces at
/// that depth.
pub const LAYER_PEELING: Listing = Listing {
    title: "Layer peeling with two geometry passes an iteration",
    source: "Carr et al. 2008, sections 1 and 8",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "layer peeling in two geometry passes, as the paper counts it";
        run OPAQUE_FIRST;
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        composited = 0;
        for (i in 0..iteration_limit) {
            iterations = i + 1;
            run BEGIN_PEEL;
            glBeginQuery(CHANGED);
            drawTransparentObjects();
            glEndQuery(CHANGED);
            changed = samples(CHANGED);
            stop if (changed == 0) because EmptyLayer;
            run BEGIN_COMPOSITING;
            run UNSORTED_AT_PEEL;
            drawTransparentObjects();
            glEndQuery(COMPOSITED);
            composited = composited + samples(COMPOSITED);
            swap(Z_PEEL, Z_PEEL_NEXT);
        }
        run OVER_OPAQUE;
    },
};

/// Lines 1 to 3.
const FROM_THE_NEAR_PLANE: Listing = Listing {
    title: "zPeel <- zNear",
    source: "Carr et al. 2008, Algorithm 1, lines 1 to 3",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(PEEL);
        glFramebufferDepth(Z_PEEL);
        glClearDepth(0.0);
        glClear(DEPTH_BUFFER_BIT);
    },
};

/// Lines 7 to 15, but for the draw: the depth test keeps the nearest, the clip those behind `zPeel`.
const BEGIN_PEEL: Listing = Listing {
    title: "Find the nearest unsorted surface behind zPeel",
    source: "Carr et al. 2008, Algorithm 1, lines 7 to 15",
    dialect: Dialect::Calls,
    steps: steps! {
        glCopyImageSubData(OPAQUE_DEPTH, Z_PEEL_NEXT);
        glBindFramebuffer(PEEL);
        glFramebufferDepth(Z_PEEL_NEXT);
        glEnable(DEPTH_TEST);
        glDepthFunc(LESS);
        glUseProgram(OPEN_OPEN);
        glActiveTexture(1);
        glBindTexture(Z_PEEL);
        glActiveTexture(2);
        glBindTexture(OPAQUE_DEPTH);
        glActiveTexture(3);
        glBindTexture(OPAQUE_DEPTH);
        glActiveTexture(4);
        glBindTexture(OPAQUE_DEPTH);
    },
};

const BEGIN_COMPOSITING: Listing = Listing {
    title: "Composite up to zPeelNext",
    source: "Carr et al. 2008, Algorithm 1, lines 16 to 28",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(ACCUMULATION);
        glDisable(DEPTH_TEST);
        run UNDER;
        glActiveTexture(2);
        glBindTexture(Z_PEEL_NEXT);
    },
};

/// Lines 16 to 20.
const SORTED_IN_RANGE: Listing = Listing {
    title: "Composite the sorted surfaces between two peels",
    source: "Carr et al. 2008, Algorithm 1, lines 16 to 20",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(BETWEEN_PEELS_AS_PRINTED);
        glBeginQuery(BETWEEN);
        drawSortedObjects();
        glEndQuery(BETWEEN);
    },
};

/// Lines 22 to 26, but for the draw and the query's end.
const UNSORTED_AT_PEEL: Listing = Listing {
    title: "Composite the surfaces at the peel's depth",
    source: "Carr et al. 2008, Algorithm 1, lines 22 to 26",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(AT_BOUND_AS_PRINTED);
        glBeginQuery(COMPOSITED);
    },
};

/// [`AMENDMENTS_1`] on OpenGL.
pub const AMENDMENTS: [Amendment; 3] = [
    Amendment {
        key: "CX21",
        kind: Kind::Correction,
        place: "Algorithm 1, line 2",
        printed: steps! { glUseProgram(OPEN_OPEN); },
        // A depth map cannot hold a depth before the near plane.
        amended: steps! {
            if (i == 0) {
                glUseProgram(CLOSED_OPEN);
            } else {
                glUseProgram(OPEN_OPEN);
            }
        },
        why: "what lies on the near plane is peeled too",
        test: "cx21_unsorted_surfaces_on_the_near_plane_are_lost",
    },
    Amendment {
        key: "CX19",
        kind: Kind::Correction,
        place: "Algorithm 1, line 17",
        printed: steps! { glUseProgram(BETWEEN_PEELS_AS_PRINTED); },
        amended: steps! { glUseProgram(CLOSED_OPEN); },
        why: "sorted surfaces at a peel's depth come right behind the unsorted ones",
        test: "cx19_sorted_surfaces_at_a_peel_depth_are_lost",
    },
    Amendment {
        key: "CX20",
        kind: Kind::Correction,
        place: "Algorithm 1, line 23",
        printed: steps! { glUseProgram(AT_BOUND_AS_PRINTED); },
        amended: steps! { glUseProgram(AT_BOUND); },
        why: "what lies on the opaque surface is hidden",
        test: "cx20_unsorted_surfaces_on_the_opaque_surface_are_composited_in_every_iteration",
    },
];

/// The resources that [`HYBRID`] and [`LAYER_PEELING`] take for granted.
pub const RESOURCES: [&Resources; 2] = [
    &stage::ACCUMULATING,
    &Resources {
        maps: &[(Z_PEEL, Holds::Depths), (Z_PEEL_NEXT, Holds::Depths)],
        framebuffers: &[Framebuffer::new(PEEL, &[], Some(Z_PEEL))],
        variables: &["iteration_limit"],
        ..Resources::NONE
    },
];

/// The depth of the last peel.
pub const Z_PEEL: Map = Map::named("zPeel");
/// The depth of the next one.
pub const Z_PEEL_NEXT: Map = Map::named("zPeelNext");

/// Line 17's range, which is open. It is the same clip as line 11's, for another purpose.
pub(super) const BETWEEN_PEELS_AS_PRINTED: Shader = Shader("clip/between_peels_as_printed");
/// Surfaces that the peel has found.
pub const CHANGED: Query = Query("gChanged");
/// Sorted surfaces that were composited.
pub const BETWEEN: Query = Query("between");
