//! Coherent layer peeling on a GPU: the loop of section 5 (variant A), and with section 6's pass (variant B).
//!
//! Each iteration finds, at every pixel, the run of surfaces behind `D(sc)` that were submitted in the right order
//! already, composites the run, and moves `D(sc)` to its end:
//!
//! ```text
//! passes 1, 2   (D(sc), opaque)                 D(sn); the nearest surface submitted before s_n:  z_min_prev
//! passes 3, 4   [D(sn), min(z_min_prev, opaque))  the nearest that interrupts the run after s_n:  z_min_post
//! passes 5, 6   [D(sn), U) in order, then U,    U = min(z_min_prev, z_min_post, opaque)
//! ```
//!
//! The paper prints the passes ([`super::passes`]) and describes in prose the ranges that a fragment shader clips to,
//! the compositing passes 5 and 6, the maps, and the end of the loop. The prose is written out here as it stands; where
//! it is wrong or silent, [`AMENDMENTS`] say what it takes. Keys X1 to X28 number what was found when it was executed.

use super::passes::{PASS_1, PASS_2, PASS_3, PASS_4, SECTION_6};
use super::*;
use crate::error::Result;
use crate::papers::vtk::{ACCUMULATED, ACCUMULATION, OPAQUE_DEPTH, OPAQUE_FIRST};
use crate::steps::{Amendment, Call, Format, Machine, Variables, Workspace, run};

/// Section 5: six geometry passes an iteration.
pub const VARIANT_A: Listing = Listing {
    title: "Coherent layer peeling with stencil counting (A)",
    source: "Carr et al. 2008, section 5",
    dialect: Dialect::Calls,
    steps: steps! {
        run OPAQUE_FIRST;
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        run LOOP_A;
        run OVER_OPAQUE;
    },
};

/// Its loop, from `D(sc)` on.
pub const LOOP_A: Listing = Listing {
    title: "The loop of coherent layer peeling (A)",
    source: "Carr et al. 2008, section 5",
    dialect: Dialect::Calls,
    steps: steps! {
        composited = 0;
        for (i in 0..iteration_limit) {
            iterations = i + 1;
            glBindFramebuffer(PEEL);
            run RANGE_1;
            run PASS_1;
            glCopyImageSubData(DEPTH_BUFFER, D_SN);
            run RANGE_2;
            run PASS_2;
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_PREV);
            run RANGE_3;
            run PASS_3;
            run PASS_4;
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST);
            run COMPOSITE_AND_GO_ON;
            stop if (found == 0) because EmptyLayer;
        }
    },
};

/// Section 6: one pass instead of passes 1 and 2, five an iteration.
pub const VARIANT_B: Listing = Listing {
    title: "Coherent layer peeling with float blending (B)",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        run OPAQUE_FIRST;
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        run LOOP_B;
        run OVER_OPAQUE;
    },
};

/// Its loop, from `D(sc)` on.
pub const LOOP_B: Listing = Listing {
    title: "The loop of coherent layer peeling (B)",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        composited = 0;
        for (i in 0..iteration_limit) {
            iterations = i + 1;
            glBindFramebuffer(PREVIOUS);
            run RANGE_6;
            run SECTION_6;
            glCopyImageSubData(DEPTH_BUFFER, D_SN);
            glBindFramebuffer(PEEL);
            run RANGE_3;
            run PASS_3;
            run PASS_4;
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST);
            run COMPOSITE_AND_GO_ON;
            stop if (found == 0) because EmptyLayer;
        }
    },
};

/// "We then initialize another depth map (which we call D(sc)) to the z-near plane."
pub const FROM_THE_NEAR_PLANE: Listing = Listing {
    title: "D(sc) at the near plane",
    source: "Carr et al. 2008, section 5.1",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BOUND);
        glClearDepth(0.0);
        glDepthMask(true);
        glClear(DEPTH_BUFFER_BIT);
    },
};

/// Pass 1's range, `(D(sc), opaque_depth)`.
pub const RANGE_1: Listing = Listing {
    title: "Clip to (D(sc), opaque_depth)",
    source: "Carr et al. 2008, section 5.1, pass 1",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(OPEN_OPEN);
        run FROM_D_SC_TO_OPAQUE;
    },
};

/// Pass 2's range, `(D(sc), opaque_depth]`.
pub const RANGE_2: Listing = Listing {
    title: "Clip to (D(sc), opaque_depth]",
    source: "Carr et al. 2008, section 5.1, pass 2",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(OPEN_CLOSED);
        run FROM_D_SC_TO_OPAQUE;
    },
};

/// Section 6's range and its shader: "we set the color to 1.0, 1.0, 1.0 and the alpha to the fragment depth".
pub const RANGE_6: Listing = Listing {
    title: "Clip to (D(sc), opaque_depth); white, and the depth as alpha",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(PREVIOUS_DEPTH);
        run FROM_D_SC_TO_OPAQUE;
    },
};

/// The range of passes 3 and 4. One scan of the paper closes its upper end, the other has no closing bracket at all.
pub const RANGE_3: Listing = Listing {
    title: "Clip to [D(sn), min(z_min_prev, opaque_depth)]",
    source: "Carr et al. 2008, section 5.1, before pass 3",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(CLOSED_CLOSED);
        glActiveTexture(1);
        glBindTexture(D_SN);
        glActiveTexture(2);
        glBindTexture(Z_MIN_PREV);
        glActiveTexture(3);
        glBindTexture(Z_MIN_PREV);
        glActiveTexture(4);
        glBindTexture(OPAQUE_DEPTH);
    },
};

/// Pass 5's range.
pub const RANGE_5: Listing = Listing {
    title: "Clip to [D(sn), min(z_min_post, z_min_prev, opaque_depth)]",
    source: "Carr et al. 2008, section 5.2, pass 5",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(CLOSED_CLOSED);
        glActiveTexture(3);
        glBindTexture(Z_MIN_POST);
    },
};

const FROM_D_SC_TO_OPAQUE: Listing = Listing {
    title: "From D(sc) to the opaque depth",
    source: "Carr et al. 2008, section 5.1",
    dialect: Dialect::Calls,
    steps: steps! {
        glActiveTexture(1);
        glBindTexture(D_SC);
        glActiveTexture(2);
        glBindTexture(OPAQUE_DEPTH);
        glActiveTexture(3);
        glBindTexture(OPAQUE_DEPTH);
        glActiveTexture(4);
        glBindTexture(OPAQUE_DEPTH);
    },
};

/// Section 5.2: passes 5 and 6, counted by an occlusion query, and the update of `D(sc)`.
pub const COMPOSITE_AND_GO_ON: Listing = Listing {
    title: "Composite the run, then go on from its end",
    source: "Carr et al. 2008, section 5.2",
    dialect: Dialect::Calls,
    steps: steps! {
        run RANGE_5;
        glBeginQuery(COMPOSITED);
        run PASS_5;
        run PASS_6;
        glEndQuery(COMPOSITED);
        run UPDATE_D_SC;
        found = samples(COMPOSITED);
        composited = composited + found;
    },
};

/// The run. The paper has no listing.
pub const PASS_5: Listing = Listing {
    title: "Pass 5: composite the run",
    source: "Carr et al. 2008, section 5.2, pass 5",
    dialect: Dialect::Calls,
    steps: steps! {
        run UNDER;
        drawTransparentObjects();
    },
};

/// The surface at its upper bound: "a z equals test in an additional compositing pass". The paper has no listing.
pub const PASS_6: Listing = Listing {
    title: "Pass 6: composite the surface at the upper bound",
    source: "Carr et al. 2008, section 5.2, pass 6",
    dialect: Dialect::Calls,
    steps: steps! {
        glUseProgram(AT_BOUND_AS_PRINTED);
        drawTransparentObjects();
    },
};

/// "We update D(sc) to be the min of z_min_prev, z_min_post, and opaque_depth."
pub const UPDATE_D_SC: Listing = Listing {
    title: "D(sc) becomes the upper bound",
    source: "Carr et al. 2008, section 5.2",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BOUND);
        glDisable(STENCIL_TEST);
        glEnable(DEPTH_TEST);
        glDepthFunc(ALWAYS);
        glUseProgram(NEXT_BOUND);
        drawScreen();
    },
};

/// Everything that makes the text right, in the paper's order.
pub const AMENDMENTS: [Amendment; 10] = [
    CLEAN_STATE,
    CLEAN_STATE_B,
    FIRST_CLOSED,
    FIRST_CLOSED_B,
    PASS_2_OPEN,
    MOVE_DEPTH,
    RUN_HALF_OPEN,
    COMPOSITE_HALF_OPEN,
    NO_TESTS,
    BEFORE_OPAQUE,
];

/// One framebuffer holds the passes' depths and the image, and the passes clear the color.
pub const CLEAN_STATE: Amendment = Amendment {
    key: "X13",
    place: "section 5.1, before pass 1; section 6, before pass 3",
    printed: steps! { glBindFramebuffer(PEEL); },
    amended: steps! {
        glBindFramebuffer(PEEL);
        glDisable(BLEND);
        glColorMask(false, false, false, false);
    },
    why: "the white clears of passes 2 and 4 would erase what has been composited",
    test: "x13_white_clears_erase_the_image",
};

/// The same for section 6's pass, whose color is the depth map.
pub const CLEAN_STATE_B: Amendment = Amendment {
    key: "X12",
    place: "section 6, before the pass",
    printed: steps! { glBindFramebuffer(PREVIOUS); },
    amended: steps! {
        glBindFramebuffer(PREVIOUS);
        glDisable(STENCIL_TEST);
        glColorMask(true, true, true, true);
    },
    why: "the stencil test of the iteration before must not meet this pass",
    test: "x12_state_left_behind_loses_surfaces",
};

/// "(D(sc), ..." leaves out what lies on the near plane.
pub const FIRST_CLOSED: Amendment = Amendment {
    key: "X9",
    place: "section 5.1, initial D(sc), pass 1",
    printed: steps! { glUseProgram(OPEN_OPEN); },
    amended: steps! {
        if (i == 0) {
            glUseProgram(CLOSED_OPEN);
        } else {
            glUseProgram(OPEN_OPEN);
        }
    },
    why: "the first range begins at the near plane, what lies on it included",
    test: "x9_surfaces_on_the_near_plane_are_lost",
};

/// The same in variant B.
pub const FIRST_CLOSED_B: Amendment = Amendment {
    key: "X9",
    place: "section 6, initial D(sc)",
    printed: steps! { glUseProgram(PREVIOUS_DEPTH); },
    amended: steps! {
        if (i == 0) {
            glUseProgram(PREVIOUS_DEPTH_FROM_NEAR);
        } else {
            glUseProgram(PREVIOUS_DEPTH);
        }
    },
    why: "the first range begins at the near plane, what lies on it included",
    test: "x9_surfaces_on_the_near_plane_are_lost",
};

/// Pass 2 counts back what pass 1 has counted, so both must see the same surfaces.
pub const PASS_2_OPEN: Amendment = Amendment {
    key: "X11",
    place: "section 5.1, pass 2, the range",
    printed: steps! { glUseProgram(OPEN_CLOSED); },
    amended: FIRST_CLOSED.amended,
    why: "pass 2 sees the surfaces that pass 1 has counted, and no others",
    test: "x11_a_closed_range_in_pass_2_only_costs_iterations",
};

/// "A blend method that multiplies the source color by the destination alpha": the printed factors multiply the
/// destination color by it.
pub const MOVE_DEPTH: Amendment = Amendment {
    key: "X16",
    place: "section 6, the blend function",
    printed: steps! { glBlendFuncSeparate(ZERO, DEST_ALPHA, ONE, ZERO); },
    amended: steps! { glBlendFuncSeparate(DEST_ALPHA, ZERO, ONE, ZERO); },
    why: "source color times destination alpha, as the text says",
    test: "x16_the_printed_blend_factors_multiply_all_earlier_depths",
};

/// Closed above, passes 3 and 4 meet the surface at `z_min_prev` again, which always breaks the run.
pub const RUN_HALF_OPEN: Amendment = Amendment {
    key: "X4",
    place: "section 5.1, the range of passes 3 and 4",
    printed: steps! { run RANGE_3; },
    amended: steps! { run RANGE_3 amended by &[HALF_OPEN]; },
    why: "the surface at z_min_prev has been found already, and would break the run",
    test: "x4_a_closed_range_in_passes_3_and_4_costs_iterations",
};

/// Closed above, pass 5 composites what pass 6 composites.
pub const COMPOSITE_HALF_OPEN: Amendment = Amendment {
    key: "X5",
    place: "section 5.2, pass 5, the range",
    printed: steps! { run RANGE_5; },
    amended: steps! { run RANGE_5 amended by &[HALF_OPEN]; },
    why: "pass 6 composites the upper bound",
    test: "x5_a_closed_range_in_pass_5_composites_the_bound_twice",
};

/// The text does not say that the tests of pass 4 end before pass 5.
pub const NO_TESTS: Amendment = Amendment {
    key: "X12",
    place: "section 5.2, before pass 5",
    printed: steps! { run PASS_5; },
    amended: steps! {
        glDisable(STENCIL_TEST);
        glDisable(DEPTH_TEST);
        glColorMask(true, true, true, true);
        run PASS_5;
    },
    why: "pass 4's stencil and depth tests take no part in compositing",
    test: "x12_state_left_behind_loses_surfaces",
};

/// [lower, upper] becomes [lower, upper).
pub const HALF_OPEN: Amendment = Amendment {
    key: "X3",
    place: "section 5, the ends of the ranges",
    printed: steps! { glUseProgram(CLOSED_CLOSED); },
    amended: steps! { glUseProgram(CLOSED_OPEN); },
    why: "half open",
    test: "x4_a_closed_range_in_passes_3_and_4_costs_iterations",
};

/// Where the bound is the opaque depth, pass 6 would composite what lies exactly on the opaque surface, every time.
pub const BEFORE_OPAQUE: Amendment = Amendment {
    key: "X8",
    place: "section 5.2, pass 6",
    printed: steps! { glUseProgram(AT_BOUND_AS_PRINTED); },
    amended: steps! { glUseProgram(AT_BOUND); },
    why: "what lies on the opaque surface is hidden, and must not keep the loop going",
    test: "x8_surfaces_on_the_opaque_surface_are_composited_for_ever",
};

/// An improvement: surfaces of equal depth do not break a run, as in Algorithm 2.
pub const TIE_FRIENDLY: Amendment = Amendment {
    key: "GEQUAL",
    place: "section 5.1, pass 3",
    printed: steps! { glDepthFunc(GREATER); },
    amended: steps! { glDepthFunc(GEQUAL); },
    why: "equal depths are in order",
    test: "tie_friendly_pass_3_peels_sorted_pairs_at_once",
};

/// An improvement: pass 1 finds nothing where nothing is left, five passes before the compositing phase says so.
pub const STOP_ON_PASS_1: Amendment = Amendment {
    key: "early stop",
    place: "section 5.2, the end of the loop",
    printed: steps! { run PASS_1; },
    amended: steps! {
        glBeginQuery(CANDIDATES);
        run PASS_1;
        glEndQuery(CANDIDATES);
        candidates = samples(CANDIDATES);
        stop if (candidates == 0) because EmptyLayer;
    },
    why: "pass 1 already knows that nothing is left",
    test: "a_query_on_pass_1_ends_a_sorted_scene_after_seven_passes",
};

/// The same in variant B.
pub const STOP_ON_SECTION_6: Amendment = Amendment {
    key: "early stop",
    place: "section 5.2, the end of the loop",
    printed: steps! { run SECTION_6; },
    amended: steps! {
        glBeginQuery(CANDIDATES);
        run SECTION_6 amended by &[MOVE_DEPTH];
        glEndQuery(CANDIDATES);
        candidates = samples(CANDIDATES);
        stop if (candidates == 0) because EmptyLayer;
    },
    why: "the first pass already knows that nothing is left",
    test: "a_query_on_pass_1_ends_a_sorted_scene_after_seven_passes",
};

/// An improvement (section 9): the range ends at a batch's end, where that lies before the opaque depth.
pub const UP_TO_THE_BATCH_END: Amendment = Amendment {
    key: "batches",
    place: "section 9; section 5.1, the ranges",
    printed: steps! { glBindTexture(OPAQUE_DEPTH); },
    amended: steps! { glBindTexture(BATCH_END); },
    why: "a batch is peeled up to its own end",
    test: "batches_give_the_same_image_in_fewer_iterations_each",
};

/// The opaque depth, or a batch's end where that is nearer.
pub const BATCH_END: Map = Map::named("batch end");

/// Sets `D(sc)` to a batch's beginning, which belongs to it, and [`BATCH_END`] to its end, which does not. Window depths.
///
/// # Errors
/// If there is no room.
pub fn begin_batch(workspace: &mut impl Workspace, begin: f32, end: f32) -> Result<()> {
    const CLEAR: Listing = Listing {
        title: "A depth everywhere",
        source: "onionskin",
        dialect: Dialect::Calls,
        steps: steps! {
            glBindFramebuffer(BOUND);
            glDepthMask(true);
            glClear(DEPTH_BUFFER_BIT);
        },
    };
    const NEARER_OF_BOTH: Listing = Listing {
        title: "The batch's end, or the opaque depth where that is nearer",
        source: "onionskin",
        dialect: Dialect::Calls,
        steps: steps! {
            glCopyImageSubData(D_SC, BATCH_END);
            glDisable(STENCIL_TEST);
            glEnable(DEPTH_TEST);
            glDepthFunc(ALWAYS);
            glUseProgram(NEXT_BOUND);
            glActiveTexture(2);
            glBindTexture(BATCH_END);
            glActiveTexture(3);
            glBindTexture(BATCH_END);
            glActiveTexture(4);
            glBindTexture(OPAQUE_DEPTH);
            drawScreen();
            glCopyImageSubData(D_SC, BATCH_END);
        },
    };
    let clear_to = |workspace: &mut _, depth: f32| {
        Machine::perform(
            workspace,
            &Call::ClearDepth {
                depth: depth.into(),
            },
        )?;
        run(&CLEAR, &[], Variables::new(), workspace)
    };
    clear_to(workspace, end)?;
    run(&NEARER_OF_BOTH, &[], Variables::new(), workspace)?;
    clear_to(workspace, begin)?;
    Ok(())
}

/// Gives [`VARIANT_A`] its maps, and with `depths_as_color` also [`VARIANT_B`], whose `z_min_prev` is a color map of that
/// format. Every depth map has the format `depth`, which must have a stencil.
///
/// # Errors
/// If there is no room.
pub fn furnish(
    workspace: &mut impl Workspace,
    color: Format,
    depth: Format,
    depths_as_color: Option<Format>,
) -> Result<()> {
    workspace.allocate(ACCUMULATED, color)?;
    for map in [DEPTH_BUFFER, D_SC, D_SN, Z_MIN_POST] {
        workspace.allocate(map, depth)?;
    }
    workspace.allocate(Z_MIN_PREV, depths_as_color.unwrap_or(depth))?;
    workspace.target_of(ACCUMULATION, &[ACCUMULATED], None)?;
    workspace.target_of(PEEL, &[ACCUMULATED], Some(DEPTH_BUFFER))?;
    workspace.target_of(BOUND, &[], Some(D_SC))?;
    if depths_as_color.is_some() {
        workspace.target_of(PREVIOUS, &[Z_MIN_PREV], Some(DEPTH_BUFFER))?;
    }
    Ok(())
}

/// Section 6's pass: `z_min_prev` as a color, with the depth buffer.
pub const PREVIOUS: Target = Target("z_min_prev");

/// White and the depth, clipped to (lower, upper).
pub const PREVIOUS_DEPTH: Shader = Shader("clip/previous_depth");
/// White and the depth, clipped to [lower, upper).
pub const PREVIOUS_DEPTH_FROM_NEAR: Shader = Shader("clip/previous_depth_from_near");
/// The upper bound as a depth.
pub const NEXT_BOUND: Shader = Shader("clip/next_bound");
/// Surfaces that pass 1 has found.
pub const CANDIDATES: Query = Query("candidates");
