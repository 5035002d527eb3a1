//! The loops of sections 5 and 6, pass by pass, as the prose around the printed passes has them.

use crate::papers::carr_2008::passes::{PASS_1, PASS_2, PASS_3, PASS_4, SECTION_6};
use crate::papers::carr_2008::shared::*;
use crate::papers::stage::{
    ACCUMULATED, ACCUMULATION, CLEAR_ACCUMULATION, OPAQUE_DEPTH, OPAQUE_FIRST, OVER_OPAQUE, PEEL,
};
use crate::steps;
use crate::steps::{
    Dialect, Framebuffer, Holds, Listing, Map, Query, Resources, Shader, Target, gl::*,
};

/// Section 5, with six geometry passes per iteration.
pub const VARIANT_A: Listing = Listing {
    title: "Coherent layer peeling with stencil counting (A)",
    source: "Carr et al. 2008, section 5",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "we render the opaque objects into a depth map";
        run OPAQUE_FIRST;
        edition "layers are accumulated apart from the opaque image";
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        prose "this process is repeated until no surfaces remain to be peeled";
        run LOOP_A;
        edition "what was accumulated goes over the opaque image";
        run OVER_OPAQUE;
    },
};

/// The loop, from `D(sc)` on.
pub const LOOP_A: Listing = Listing {
    title: "The loop of coherent layer peeling (A)",
    source: "Carr et al. 2008, section 5",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "surfaces and iterations are counted";
        composited = 0;
        prose "this process is repeated until no surfaces remain to be peeled";
        for (i in 0..iteration_limit) {
            edition "surfaces and iterations are counted";
            iterations = i + 1;
            edition "maps are drawn to through framebuffers";
            glBindFramebuffer(PEEL);
            run RANGE_1;
            run PASS_1;
            prose "the depth buffer will hold D(sn), required in subsequent steps";
            glCopyImageSubData(DEPTH_BUFFER, D_SN);
            run RANGE_2;
            run PASS_2;
            prose "the result of this process records z_min_prev into the z-buffer";
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_PREV);
            run RANGE_3;
            run PASS_3;
            run PASS_4;
            prose "this value is z_min_post";
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST);
            run COMPOSITE_AND_GO_ON;
            prose "we can detect when this occurs using occlusion queries during the compositing phase";
            stop if (found == 0) because EmptyLayer;
        }
    },
};

/// Section 6, with one pass instead of passes 1 and 2, so five per iteration.
pub const VARIANT_B: Listing = Listing {
    title: "Coherent layer peeling with float blending (B)",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "we render the opaque objects into a depth map";
        run OPAQUE_FIRST;
        edition "layers are accumulated apart from the opaque image";
        run CLEAR_ACCUMULATION;
        run FROM_THE_NEAR_PLANE;
        prose "this process is repeated until no surfaces remain to be peeled";
        run LOOP_B;
        edition "what was accumulated goes over the opaque image";
        run OVER_OPAQUE;
    },
};

/// The loop, from `D(sc)` on.
pub const LOOP_B: Listing = Listing {
    title: "The loop of coherent layer peeling (B)",
    source: "Carr et al. 2008, section 6",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "surfaces and iterations are counted";
        composited = 0;
        prose "this process is repeated until no surfaces remain to be peeled";
        for (i in 0..iteration_limit) {
            edition "surfaces and iterations are counted";
            iterations = i + 1;
            edition "maps are drawn to through framebuffers";
            glBindFramebuffer(PREVIOUS);
            run RANGE_6;
            run SECTION_6;
            prose "the depth buffer will hold D(sn), required in subsequent steps";
            glCopyImageSubData(DEPTH_BUFFER, D_SN);
            edition "maps are drawn to through framebuffers";
            glBindFramebuffer(PEEL);
            run RANGE_3;
            run PASS_3;
            run PASS_4;
            prose "this value is z_min_post";
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST);
            run COMPOSITE_AND_GO_ON;
            prose "we can detect when this occurs using occlusion queries during the compositing phase";
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
        edition "maps are drawn to through framebuffers";
        glBindFramebuffer(BOUND);
        prose "we then initialize another depth map (which we call D(sc)) to the z-near plane";
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
        prose "whose depth values lie in the range (D(sc),opaque_depth)";
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
        prose "any surface si : i < n in the range (D(sc),opaque_depth]";
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
        prose "we set the color to 1.0, 1.0, 1.0 and the alpha to the fragment depth";
        glUseProgram(PREVIOUS_DEPTH);
        run FROM_D_SC_TO_OPAQUE;
    },
};

/// The range of passes 3 and 4, whose closing bracket is missing: read literally, nothing excludes its end.
pub const RANGE_3: Listing = Listing {
    title: "Clip to [D(sn), min(z_min_prev, opaque_depth)",
    source: "Carr et al. 2008, section 5.1, before pass 3",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "we clip all surface fragments that fall outside the range [D(sn),min(z_min_prev,opaque_depth) using a simple fragment shader";
        glUseProgram(CLOSED_CLOSED);
        edition "the shader looks the lower end up on unit 1, and the upper one, the least of three, on units 2 to 4";
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
    title: "Clip to [D(sn), min(z_min_post, z_min_prev, opaque_depth)",
    source: "Carr et al. 2008, section 5.2, pass 5",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "the interval [D(sn),min(z_min_post,z_min_prev,opaque_depth) ... can use a fragment shader to clip to this range";
        glUseProgram(CLOSED_CLOSED);
        edition "the shader looks the third upper end up on unit 3";
        glActiveTexture(3);
        glBindTexture(Z_MIN_POST);
    },
};

const FROM_D_SC_TO_OPAQUE: Listing = Listing {
    title: "From D(sc) to the opaque depth",
    source: "Carr et al. 2008, section 5.1",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the shader looks the lower end up on unit 1, and the upper one, the least of three, on units 2 to 4";
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
        prose "we can detect when this occurs using occlusion queries during the compositing phase";
        glBeginQuery(COMPOSITED);
        run PASS_5;
        run PASS_6;
        glEndQuery(COMPOSITED);
        run UPDATE_D_SC;
        prose "we can detect when this occurs using occlusion queries during the compositing phase";
        found = samples(COMPOSITED);
        edition "surfaces and iterations are counted";
        composited = composited + found;
    },
};

/// Pass 5 composites the run. The paper has no listing of it.
pub const PASS_5: Listing = Listing {
    title: "Pass 5: composite the run",
    source: "Carr et al. 2008, section 5.2, pass 5",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "a standard compositing pass ... to accumulate these surfaces into the final image (pass 5)";
        run UNDER;
        drawTransparentObjects();
    },
};

/// Pass 6 composites the surface at the upper bound: "a z equals test in an additional compositing pass". The paper has
/// no listing of it.
pub const PASS_6: Listing = Listing {
    title: "Pass 6: composite the surface at the upper bound",
    source: "Carr et al. 2008, section 5.2, pass 6",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "we can peel this surface away as well using a z equals test in an additional compositing pass (pass 6)";
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
        edition "maps are drawn to through framebuffers";
        glBindFramebuffer(BOUND);
        edition "the draw writes the depth of every pixel";
        glDisable(STENCIL_TEST);
        glEnable(DEPTH_TEST);
        glDepthFunc(ALWAYS);
        prose "we update D(sc) to be the min of z_min_prev, z_min_post, and opaque_depth";
        glUseProgram(NEXT_BOUND);
        drawScreen();
    },
};

/// The resources that variant A takes for granted.
pub const RESOURCES_A: [&Resources; 2] = [
    &COMMON,
    &Resources {
        maps: &[(Z_MIN_PREV, Holds::Depths)],
        ..Resources::NONE
    },
];

/// The resources that variant B takes for granted. Its `z_min_prev` is a color.
pub const RESOURCES_B: [&Resources; 2] = [
    &COMMON,
    &Resources {
        maps: &[(Z_MIN_PREV, Holds::Colors)],
        framebuffers: &[Framebuffer::new(
            PREVIOUS,
            &[Z_MIN_PREV],
            Some(DEPTH_BUFFER),
        )],
        ..Resources::NONE
    },
];

/// Of both. The depth buffer needs a stencil.
const COMMON: Resources = Resources {
    maps: &[
        (ACCUMULATED, Holds::Colors),
        (DEPTH_BUFFER, Holds::Depths),
        (D_SC, Holds::Depths),
        (D_SN, Holds::Depths),
        (Z_MIN_POST, Holds::Depths),
    ],
    made: &[BATCH_END],
    framebuffers: &[
        Framebuffer::new(ACCUMULATION, &[ACCUMULATED], None),
        Framebuffer::new(PEEL, &[ACCUMULATED], Some(DEPTH_BUFFER)),
        Framebuffer::new(BOUND, &[], Some(D_SC)),
    ],
    variables: &["iteration_limit"],
    ..Resources::NONE
};

/// The opaque depth, or a batch's end if that is nearer.
pub const BATCH_END: Map = Map::named("batch end");

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
