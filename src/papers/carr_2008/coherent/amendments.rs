//! The amendments to sections 5 and 6: corrections, then improvements. Keys CX01 to CX28 number the errors that were found
//! when the text was executed.

use super::loops::*;
use crate::papers::carr_2008::passes::{PASS_1, SECTION_6};
use crate::papers::carr_2008::shared::*;
use crate::papers::stage::{OPAQUE_DEPTH, PEEL};
use crate::steps;
use crate::steps::{Amendment, Kind, gl::*};

/// What fills the paper's silence and what corrects it, in the paper's order.
pub const AMENDMENTS: [Amendment; 9] = [
    CLEAN_STATE,
    FIRST_CLOSED,
    FIRST_CLOSED_B,
    PASS_2_OPEN,
    MOVE_DEPTH,
    RUN_HALF_OPEN,
    COMPOSITE_HALF_OPEN,
    NO_TESTS,
    BEFORE_OPAQUE,
];

/// What fills the paper's silence, alone.
pub const FILLINGS: [Amendment; 4] = [CLEAN_STATE, RUN_HALF_OPEN, COMPOSITE_HALF_OPEN, NO_TESTS];

/// One framebuffer holds the passes' depths and the image, and the passes clear its color.
pub const CLEAN_STATE: Amendment = Amendment {
    key: "CX13",
    kind: Kind::Filling(
        "Section 5.1: each pass leaves a count or a depth; section 5.2: \"into the final image (pass 5)\"",
    ),
    place: "section 5.1, before pass 1, and section 6, before pass 3: where the passes' colour goes",
    printed: steps! { glBindFramebuffer(PEEL); },
    amended: steps! {
        glBindFramebuffer(PEEL);
        glColorMask(false, false, false, false);
    },
    why: "the white clears of passes 2 and 4 would erase what has been composited",
    test: "cx13_white_clears_erase_the_image",
};

/// "(D(sc), ..." leaves out surfaces on the near plane.
pub const FIRST_CLOSED: Amendment = Amendment {
    key: "CX09",
    kind: Kind::Correction,
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
    test: "cx09_surfaces_on_the_near_plane_are_lost",
};

/// The same in variant B.
pub const FIRST_CLOSED_B: Amendment = Amendment {
    key: "CX09",
    kind: Kind::Correction,
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
    test: "cx09_surfaces_on_the_near_plane_are_lost",
};

/// Pass 2 counts back what pass 1 has counted, so both must see the same surfaces. Pass 1's program is bound still.
pub const PASS_2_OPEN: Amendment = Amendment {
    key: "CX11",
    kind: Kind::Edition,
    place: "section 5.1, pass 2, the range",
    printed: steps! { glUseProgram(OPEN_CLOSED); },
    amended: steps! {},
    why: "pass 2 sees the surfaces that pass 1 has counted, and no others",
    test: "cx11_a_closed_range_in_pass_2_only_costs_iterations",
};

/// "A blend method that multiplies the source color by the destination alpha": the printed factors multiply the
/// destination color by it.
pub const MOVE_DEPTH: Amendment = Amendment {
    key: "CX16",
    kind: Kind::Correction,
    place: "section 6, the blend function",
    printed: steps! { glBlendFuncSeparate(ZERO, DEST_ALPHA, ONE, ZERO); },
    amended: steps! { glBlendFuncSeparate(DEST_ALPHA, ZERO, ONE, ZERO); },
    why: "source color times destination alpha, as the text says",
    test: "cx16_the_printed_blend_factors_multiply_all_earlier_depths",
};

/// If the range is closed above, passes 3 and 4 meet the surface at `z_min_prev` again, which always breaks the run.
pub const RUN_HALF_OPEN: Amendment = Amendment {
    key: "CX04",
    kind: Kind::Filling(HALF_OPEN_RESTS_ON),
    place: "section 5.1, the range of passes 3 and 4",
    printed: steps! { run RANGE_3; },
    amended: steps! { run RANGE_3 amended by &[HALF_OPEN]; },
    why: "the surface at z_min_prev has been found already, and would break the run",
    test: "cx04_a_closed_range_in_passes_3_and_4_costs_iterations",
};

/// If the range is closed above, pass 5 composites the surface that pass 6 composites.
pub const COMPOSITE_HALF_OPEN: Amendment = Amendment {
    key: "CX05",
    kind: Kind::Filling(HALF_OPEN_RESTS_ON),
    place: "section 5.2, pass 5, the range",
    printed: steps! { run RANGE_5; },
    amended: steps! { run RANGE_5 amended by &[HALF_OPEN]; },
    why: "pass 6 composites the upper bound",
    test: "cx05_a_closed_range_in_pass_5_composites_the_bound_twice",
};

/// The text does not say that pass 4's tests are disabled before pass 5.
pub const NO_TESTS: Amendment = Amendment {
    key: "CX12",
    kind: Kind::Filling("Section 5.2: \"A standard compositing pass\""),
    place: "section 5.2, before pass 5: which tests are on",
    printed: steps! { run UNDER; },
    amended: steps! {
        glDisable(STENCIL_TEST);
        glDisable(DEPTH_TEST);
        glColorMask(true, true, true, true);
        run UNDER;
    },
    why: "pass 4's stencil and depth tests take no part in compositing",
    test: "cx12_state_left_behind_loses_surfaces",
};

/// Sections 5.1 and 5.2 print no closing bracket. Of all orders of submission that fit figure 2's trace, half-open ranges
/// fit 18, and closed ones none.
const HALF_OPEN_RESTS_ON: &str = "Section 4.1: \"within the range [D(sn),z_min_prev)\"; figure 2, whose trace fits no closed range";

/// [lower, upper] becomes [lower, upper).
pub const HALF_OPEN: Amendment = Amendment {
    key: "CX03",
    kind: Kind::Filling(HALF_OPEN_RESTS_ON),
    place: "section 5, the ends of the ranges",
    printed: steps! { glUseProgram(CLOSED_CLOSED); },
    amended: steps! { glUseProgram(CLOSED_OPEN); },
    why: "half open",
    test: "cx04_a_closed_range_in_passes_3_and_4_costs_iterations",
};

/// If the bound is the opaque depth, pass 6 would composite surfaces exactly on the opaque surface, in every iteration.
pub const BEFORE_OPAQUE: Amendment = Amendment {
    key: "CX08",
    kind: Kind::Correction,
    place: "section 5.2, pass 6",
    printed: steps! { glUseProgram(AT_BOUND_AS_PRINTED); },
    amended: steps! { glUseProgram(AT_BOUND); },
    why: "what lies on the opaque surface is hidden, and must not keep the loop going",
    test: "cx08_surfaces_on_the_opaque_surface_are_composited_for_ever",
};

/// An improvement: surfaces of equal depth do not break a run, as in Algorithm 2.
pub const TIE_FRIENDLY: Amendment = Amendment {
    key: "GEQUAL",
    kind: Kind::Edition,
    place: "section 5.1, pass 3",
    printed: steps! { glDepthFunc(GREATER); },
    amended: steps! { glDepthFunc(GEQUAL); },
    why: "equal depths are in order",
    test: "tie_friendly_pass_3_peels_sorted_pairs_at_once",
};

/// An improvement: if nothing is left, pass 1 finds nothing, five passes before the compositing phase notices it.
pub const STOP_ON_PASS_1: Amendment = Amendment {
    key: "early stop",
    kind: Kind::Edition,
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
    kind: Kind::Edition,
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

/// An improvement (section 9): the range ends at a batch's end if that lies before the opaque depth.
pub const UP_TO_THE_BATCH_END: Amendment = Amendment {
    key: "batches",
    kind: Kind::Edition,
    place: "section 9; section 5.1, the ranges",
    printed: steps! { glBindTexture(OPAQUE_DEPTH); },
    amended: steps! { glBindTexture(BATCH_END); },
    why: "a batch is peeled up to its own end",
    test: "batches_give_the_same_image_in_fewer_iterations_each",
};
