//! VTK's depth peeling page: Everitt's algorithm in a toolkit.
//!
//! The page has no listing. Its prose is written out here. Opaque geometry comes first, and its depth bounds the peels.
//! Each peel has an occlusion query. There are two ways to stop, and the two ways to composite that the page compares.
//! The loop itself is Everitt's Listing 1, amended.

mod claims;
mod errata;
mod improvements;
mod requirements;

pub use improvements::{ALIVE, LATE_QUERY, UNDER_FIRST, UNDER_LATER};
pub use requirements::{ALPHA_BITS, REQUIRED_EXTENSIONS, missing_extensions};

use super::paper::Paper;
use crate::papers::everitt_2001::composite::{ALPHA, COMPOSITE as BACK_TO_FRONT, LAYER_I};
use crate::papers::everitt_2001::listing_1::LISTING_1;
use crate::papers::stage::{
    self, ACCUMULATION, CLEAR_ACCUMULATION, COMPOSITE, LAYER, OPAQUE_DEPTH, OPAQUE_FIRST,
    OVER_OPAQUE, PEEL, PEEL_SURFACE,
};
use crate::steps;
use crate::steps::{
    Amendment, Dialect, Framebuffer, Holds, Kind, Listing, Map, Query, Resources, Shader, Text,
    gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "vtk",
    citation: "VTK wiki, Depth Peeling, 2006",
    texts: &[
        ("opaque-first", Text::Listing(CULLING, &[])),
        ("keep-layers", Text::Listing(KEEP_LAYERS, &[])),
        ("on-the-fly", Text::Listing(ON_THE_FLY, &[])),
    ],
    resources: &[
        &stage::RESOURCES.of(
            &["opaque-first", "keep-layers", "on-the-fly"],
            &[stage::SURFACE],
        ),
        &PEELING.of(&["keep-layers"], &[PEEL_SURFACE, OVER]),
        &Resources {
            made: &[],
            ..PEELING.of(&["on-the-fly"], &[PEEL_SURFACE])
        },
        &stage::ACCUMULATING.of(&["on-the-fly"], &[UNDER_LAYER, LAYER]),
    ],
    claims: claims::CLAIMS,
    errata: errata::ERRATA,
};

/// Opaque geometry comes first.
pub const CULLING: Listing = Listing {
    title: "Opaque geometry comes first",
    source: "VTK, Implementation notes",
    dialect: Dialect::Calls,
    steps: steps! {
        prose "As we first render opaque geometry, we use it to cull transparent geometry";
        run OPAQUE_FIRST;
    },
};

/// Every layer is kept, then composited back to front ("Implementation notes").
pub const KEEP_LAYERS: Listing = Listing {
    title: "Depth peeling with every layer kept, composited back to front",
    source: "VTK, Depth Peeling",
    dialect: Dialect::Calls,
    steps: steps! {
        run CULLING;
        run BEFORE_PEELING;
        edition "layers and fragments are counted";
        num_layers = 0;
        composited = 0;
        prose "the algorithm peels the translucent geometry from front to back until there is no more geometry to render";
        run LISTING_1 amended by &[CULL_BY_OPAQUE, QUERY, KEEP_DEPTH];
        edition "maps are drawn to through framebuffers";
        glBindFramebuffer(COMPOSITE);
        prose "the last step perfoms compositing with each layer, back-to-front order";
        run BACK_TO_FRONT amended by &[WITH_ALPHA, ONLY_THE_LAYER, COUNT_THE_LAYER];
    },
};

/// No layer is kept: each goes under those before it as soon as it is there ("if it was possible to do front-to-back
/// compositing, we could perform compositing on the fly").
pub const ON_THE_FLY: Listing = Listing {
    title: "Depth peeling with front-to-back compositing on the fly",
    source: "VTK, Depth Peeling",
    dialect: Dialect::Calls,
    steps: steps! {
        run CULLING;
        run CLEAR_ACCUMULATION;
        run BEFORE_PEELING;
        edition "layers and fragments are counted";
        num_layers = 0;
        composited = 0;
        prose "the algorithm peels the translucent geometry from front to back until there is no more geometry to render";
        run LISTING_1 amended by &[NO_CLEAR, CULL_BY_OPAQUE, QUERY, UNDER];
        edition "what was accumulated goes over the opaque image";
        run OVER_OPAQUE;
    },
};

/// The peels' own: colours and two depth buffers, and the layers if they are kept.
pub const PEELING: Resources = Resources {
    maps: &[
        (COLOR_BUFFER, Holds::Colors),
        (DEPTH_BUFFERS[0], Holds::Depths),
        (DEPTH_BUFFERS[1], Holds::Depths),
    ],
    made: &[LAYER_I, LAYER_DEPTH_I],
    framebuffers: &[Framebuffer::new(
        PEEL,
        &[COLOR_BUFFER],
        Some(DEPTH_BUFFERS[0]),
    )],
    variables: &["num_passes", "occlusion_ratio", "window_area"],
    ..Resources::NONE
};

/// The state that Listing 1 takes for granted: a framebuffer to draw into, and a program.
pub const BEFORE_PEELING: Listing = Listing {
    title: "What the peels draw into, and with",
    source: "VTK, Implementation notes",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "Listing 1 takes a framebuffer and a program for granted";
        // Layers are told from background by their depth, so no colour needs to be special.
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glBindFramebuffer(PEEL);
        glActiveTexture(1);
        glBindTexture(OPAQUE_DEPTH);
        glUseProgram(PEEL_SURFACE);
    },
};

/// The first [`Amendment`] to Listing 1: the peel's depth buffer starts from the opaque depth instead of from the far
/// plane, so that the ordinary depth test of unit 1 culls fragments at or behind an opaque surface.
pub const CULL_BY_OPAQUE: Amendment = Amendment {
    key: "V03",
    kind: Kind::Prose("As we first render opaque geometry, we use it to cull transparent geometry"),
    place: "Listing 1, depth unit 1, clear depth buffer",
    printed: steps! { clear depth buffer; },
    amended: steps! { glCopyImageSubData(OPAQUE_DEPTH, DEPTH_BUFFER_B); },
    why: "opaque geometry culls what lies behind it",
    test: "v03_opaque_geometry_culls_what_lies_behind_it_and_lowers_the_number_of_layers",
};

/// "An occlusion query test on each pass indicates whether that layer was empty; if it was, the algorithm halts." Only
/// the transparent objects are peeled.
pub const QUERY: Amendment = Amendment {
    key: "V04",
    kind: Kind::Prose(
        "an occlusion query test on each pass indicates whether that layer was empty; if it was, the algorithm halts",
    ),
    place: "Listing 1, render scene",
    printed: steps! { render scene; },
    amended: steps! {
        edition "peels are counted";
        peels = i + 1;
        prose "an occlusion query test on each pass indicates whether that layer was empty; if it was, the algorithm halts";
        glBeginQuery(PEELED);
        drawTransparentObjects();
        glEndQuery(PEELED);
        peeled = samples(PEELED);
        stop if (peeled == 0) because EmptyLayer;
    },
    why: "an occlusion query finds the empty layer",
    test: "v04_the_empty_layer_ends_the_loop",
};

/// The layer is saved with its depth. Its pixels are counted if there is an occlusion ratio; without one the count would
/// stop nothing, and cost a pass over the screen. The query above would not do: it counts every fragment that lowered the
/// depth, and those are more than the pixels that changed.
pub const KEEP_DEPTH: Amendment = Amendment {
    key: "V02",
    kind: Kind::Prose(
        "the number of pixels modified by the last peel is less than some ratio of the area of the window",
    ),
    place: "Listing 1, save color buffer RGBA as layer i",
    printed: steps! { save color buffer RGBA as layer i; },
    amended: steps! {
        save color buffer RGBA as layer i;
        edition "a layer's depths tell its pixels from the background";
        glCopyImageSubData(DEPTH_BUFFER_B, LAYER_DEPTH_I);
        num_layers = i + 1;
        if (occlusion_ratio > 0) {
            edition "a draw over the screen counts the layer's pixels, which the query of the peel does not";
            glColorMask(false, false, false, false);
            glBindFramebuffer(COMPOSITE);
            glUseProgram(OVER);
            glActiveTexture(3);
            glBindTexture(DEPTH_BUFFER_B);
            glBeginQuery(PIXELS);
            drawScreen();
            glEndQuery(PIXELS);
            glColorMask(true, true, true, true);
            glUseProgram(PEEL_SURFACE);
            glBindFramebuffer(PEEL);
            prose "the number of pixels modified by the last peel is less than some ratio of the area of the window";
            pixels = samples(PIXELS);
            stop if (pixels < (occlusion_ratio * window_area)) because OcclusionRatio;
        }
    },
    why: "a peel that changed too few pixels is the last",
    test: "v02_the_loop_stops_when_a_peel_changed_fewer_pixels_than_the_ratio",
};

/// When a layer goes under the others, only its own pixels are read, so the rest of the color buffer does not matter.
/// This does not hold for a layer that is saved. Clearing 32-bit float colours costs a twentieth of a peel.
pub const NO_CLEAR: Amendment = Amendment {
    key: "V06",
    kind: Kind::Edition,
    place: "Listing 1, clear color buffer",
    printed: steps! { clear color buffer; },
    amended: steps! {},
    why: "only the layer's own pixels will be read",
    test: "v06_both_ways_of_compositing_give_the_same_image",
};

/// Instead of saving the layer, this puts it under the layers composited so far. The query counts the layer's pixels.
pub const UNDER: Amendment = Amendment {
    key: "V06",
    kind: Kind::Prose(
        "if it was possible to do front-to-back compositing, we could perform compositing on the fly",
    ),
    place: "Listing 1, save color buffer RGBA as layer i",
    printed: steps! { save color buffer RGBA as layer i; },
    amended: steps! {
        edition "layers are accumulated apart from the opaque image";
        glBindFramebuffer(ACCUMULATION);
        prose "if it was possible to do front-to-back compositing, we could perform compositing on the fly";
        glEnable(BLEND);
        glBlendFuncSeparate(ONE_MINUS_DST_ALPHA, ONE, ONE_MINUS_DST_ALPHA, ONE);
        glUseProgram(UNDER_LAYER);
        edition "the shader looks the layer's depths up on unit 3, and its colours on unit 2; its pixels are counted";
        glActiveTexture(3);
        glBindTexture(DEPTH_BUFFER_B);
        glActiveTexture(2);
        glBindTexture(COLOR_BUFFER);
        glBeginQuery(PIXELS);
        prose "if it was possible to do front-to-back compositing, we could perform compositing on the fly";
        drawScreen();
        edition "layers and their pixels are counted";
        glEndQuery(PIXELS);
        glDisable(BLEND);
        pixels = samples(PIXELS);
        composited = composited + pixels;
        num_layers = i + 1;
        prose "the number of pixels modified by the last peel is less than some ratio of the area of the window";
        stop if (pixels < (occlusion_ratio * window_area)) because OcclusionRatio;
        edition "back to what the peels draw into, and with";
        glBindFramebuffer(PEEL);
        glUseProgram(PEEL_SURFACE);
    },
    why: "front-to-back compositing on the fly keeps no layer",
    test: "v06_both_ways_of_compositing_give_the_same_image",
};

/// To [`COMPOSITE`](BACK_TO_FRONT): the page names no blend function.
const WITH_ALPHA: Amendment = Amendment {
    kind: Kind::Edition,
    ..ALPHA
};

/// To [`COMPOSITE`](BACK_TO_FRONT): a layer does not cover every pixel, and those it covers are counted.
pub const ONLY_THE_LAYER: Amendment = Amendment {
    key: "V06",
    kind: Kind::Edition,
    place: "Putting It All Together, rendering each layer",
    printed: steps! { glUseProgram(LAYER); },
    amended: steps! { glUseProgram(OVER); },
    why: "a layer is where its depth lies before the opaque depth",
    test: "every_pixel_of_a_layer_is_counted_once",
};

/// Goes with [`ONLY_THE_LAYER`].
pub const COUNT_THE_LAYER: Amendment = Amendment {
    key: "V06",
    kind: Kind::Edition,
    place: "Putting It All Together, rendering each layer",
    printed: steps! { drawScreen(); },
    amended: steps! {
        glActiveTexture(3);
        glBindTexture(LAYER_DEPTH_I);
        glActiveTexture(2);
        glBeginQuery(PIXELS);
        drawScreen();
        glEndQuery(PIXELS);
        composited = composited + samples(PIXELS);
    },
    why: "its pixels are counted",
    test: "every_pixel_of_a_layer_is_counted_once",
};

/// The color buffer of the peels.
pub const COLOR_BUFFER: Map = Map::named("color buffer");
/// The depths of the layers before this one and of this one.
pub const DEPTH_BUFFERS: [Map; 2] = [
    Map::numbered("depth buffer", 0),
    Map::numbered("depth buffer", 1),
];
const DEPTH_BUFFER_B: Map = Map::at("depth buffer", "B");
const LAYER_DEPTH_I: Map = Map::at("layer depth", "i");
const OVER: Shader = Shader("over");
/// Puts a layer under those before it.
pub const UNDER_LAYER: Shader = Shader("under");
const PEELED: Query = Query("peeled");
const PIXELS: Query = Query("pixels");
