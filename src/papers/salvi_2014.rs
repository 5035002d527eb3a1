//! Marco Salvi and Karthik Vaidyanathan, *Multi-layer Alpha Blending*, Symposium on Interactive 3D Graphics and Games,
//! 2014.
//!
//! One pass over the surfaces, in any order, and in bounded memory. A pixel has a few nodes, sorted by depth. Each fragment
//! becomes a node. If that makes one node too many, the two farthest nodes are merged.

use super::paper::Paper;
use crate::papers::stage;
use crate::steps;
use crate::steps::{
    Amendment, Dialect, Format, Framebuffer, Holds, Kind, Listing, Map, Query, Resources, Shader,
    Target, Text, gl::*,
};

/// Its texts.
pub const PAPER: Paper = Paper {
    key: "salvi",
    citation: "Marco Salvi and Karthik Vaidyanathan, Multi-layer Alpha Blending, I3D 2014",
    texts: &[
        ("four-nodes", Text::Listing(FOUR_NODES, &[])),
        ("eight-nodes", Text::Listing(EIGHT_NODES, &[])),
    ],
    resources: &[
        &stage::RESOURCES,
        &RESOURCES_OF_FOUR.of(&["four-nodes"], SHADERS),
        &RESOURCES_OF_EIGHT.of(&["eight-nodes"], SHADERS),
    ],
    claims: &[],
    errata: &[],
};

/// The whole algorithm, with four nodes for each pixel.
pub const FOUR_NODES: Listing = Listing {
    title: "Multi-layer alpha blending, with four nodes for each pixel",
    source: "Salvi and Vaidyanathan 2014",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the paper's algorithm, in calls of OpenGL 4";
        run stage::OPAQUE_FIRST;
        run INSERT;
        run FIRST_NODES;
        run COMPOSITE;
    },
};

/// The whole algorithm, with eight nodes for each pixel.
pub const EIGHT_NODES: Listing = Listing {
    title: "Multi-layer alpha blending, with eight nodes for each pixel",
    source: "Salvi and Vaidyanathan 2014",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the paper's algorithm, in calls of OpenGL 4";
        run stage::OPAQUE_FIRST;
        run INSERT;
        run FIRST_NODES;
        run FURTHER_NODES;
        run COMPOSITE;
    },
};

const INSERT: Listing = Listing {
    title: "Each fragment becomes a node, and if that is one too many, the two farthest are merged",
    source: "Salvi and Vaidyanathan 2014, the transparent pass",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(ALL_NODES);
        glDepthMask(false);
        glDisable(DEPTH_TEST);
        glUseProgram(BEGIN);
        drawScreen();
        glEnable(DEPTH_TEST);
        glUseProgram(INSERTION);
        drawTransparentObjects();
        glDepthMask(true);
    },
};

const FIRST_NODES: Listing = Listing {
    title: "The first four nodes are looked up",
    source: "Salvi and Vaidyanathan 2014",
    dialect: Dialect::Calls,
    steps: steps! {
        glActiveTexture(0);
        glBindTexture(node(0));
        glActiveTexture(1);
        glBindTexture(node(1));
        glActiveTexture(2);
        glBindTexture(node(2));
        glActiveTexture(3);
        glBindTexture(node(3));
    },
};

const FURTHER_NODES: Listing = Listing {
    title: "The other four nodes are looked up",
    source: "Salvi and Vaidyanathan 2014",
    dialect: Dialect::Calls,
    steps: steps! {
        glActiveTexture(4);
        glBindTexture(node(4));
        glActiveTexture(5);
        glBindTexture(node(5));
        glActiveTexture(6);
        glBindTexture(node(6));
        glActiveTexture(7);
        glBindTexture(node(7));
    },
};

/// Its blend function for colours; alpha stays the opaque image's.
const COMPOSITE: Listing = Listing {
    title: "The nodes are composited front to back, over the opaque image",
    source: "Salvi and Vaidyanathan 2014",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(stage::COMPOSITE);
        glDisable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendFuncSeparate(ONE, SRC_ALPHA, ZERO, ONE);
        glUseProgram(FRONT_TO_BACK);
        drawScreen();
        glDisable(BLEND);
    },
};

/// Counts the nodes that a frame has filled, over all pixels. So many fragments have a node of their own. The variable
/// `nodes` is the number of a pixel's nodes, and `taken` becomes the count.
pub const COUNT_TAKEN: Listing = Listing {
    title: "The filled nodes are counted",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "what the method has left of the fragments";
        glBindFramebuffer(stage::COMPOSITE);
        glColorMask(false, false, false, false);
        glDisable(DEPTH_TEST);
        glUseProgram(TAKEN);
        glActiveTexture(0);
        taken = 0;
        for (i in 0..nodes) {
            glBindTexture(Map::at("node", "i"));
            glBeginQuery(HAVE_TAKEN);
            drawScreen();
            glEndQuery(HAVE_TAKEN);
            taken = taken + samples(HAVE_TAKEN);
        }
        glColorMask(true, true, true, true);
    },
};

/// Amends [`FOUR_NODES`]. The nodes are images, which fragments load and store in their turns. Without it they are color
/// maps, which fragments fetch.
pub const FOUR_IMAGES: Amendment = Amendment {
    amended: steps! {
        run BIND_FIRST_IMAGES;
        run INSERT_INTO_IMAGES;
    },
    ..EIGHT_IMAGES
};

/// The same to [`EIGHT_NODES`].
pub const EIGHT_IMAGES: Amendment = Amendment {
    key: "images",
    kind: Kind::Edition,
    place: "the transparent pass",
    printed: steps! {
        glEnable(DEPTH_TEST);
        glUseProgram(INSERTION);
        drawTransparentObjects();
    },
    amended: steps! {
        run BIND_FIRST_IMAGES;
        run BIND_FURTHER_IMAGES;
        run INSERT_INTO_IMAGES;
    },
    why: "the nodes are images",
    test: "by_images_every_image_is_the_same",
};

const BIND_FIRST_IMAGES: Listing = Listing {
    title: "The first four nodes are images",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindImageTexture(0, node(0));
        glBindImageTexture(1, node(1));
        glBindImageTexture(2, node(2));
        glBindImageTexture(3, node(3));
    },
};

const BIND_FURTHER_IMAGES: Listing = Listing {
    title: "The other four nodes are images",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindImageTexture(4, node(4));
        glBindImageTexture(5, node(5));
        glBindImageTexture(6, node(6));
        glBindImageTexture(7, node(7));
    },
};

const INSERT_INTO_IMAGES: Listing = Listing {
    title: "Fragments load and store them in their turns",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        // For shaders that compare 1/w themselves.
        glCopyImageSubData(stage::OPAQUE_DEPTH, HIDING);
        glActiveTexture(5);
        glBindTexture(HIDING);
        glActiveTexture(0);
        glBindFramebuffer(NO_COLORS);
        glMemoryBarrier();
        glEnable(DEPTH_TEST);
        glUseProgram(INSERTION);
        drawTransparentObjects();
        glMemoryBarrier();
    },
};

/// What [`FOUR_NODES`] takes for granted.
pub const RESOURCES_OF_FOUR: Resources = Resources {
    maps: MAPS.split_at(4).0,
    made: &[HIDING],
    framebuffers: &[
        Framebuffer::new(ALL_NODES, NODES.split_at(4).0, Some(stage::OPAQUE_DEPTH)),
        Framebuffer::new(NO_COLORS, &[], Some(stage::OPAQUE_DEPTH)),
    ],
    ..Resources::NONE
};

/// What [`EIGHT_NODES`] takes for granted. OpenGL promises no more than eight color maps.
pub const RESOURCES_OF_EIGHT: Resources = Resources {
    maps: MAPS,
    made: &[HIDING],
    framebuffers: &[
        Framebuffer::new(ALL_NODES, NODES, Some(stage::OPAQUE_DEPTH)),
        Framebuffer::new(NO_COLORS, &[], Some(stage::OPAQUE_DEPTH)),
    ],
    ..Resources::NONE
};

const MAPS: &[(Map, Holds)] = &[
    (node(0), NODE),
    (node(1), NODE),
    (node(2), NODE),
    (node(3), NODE),
    (node(4), NODE),
    (node(5), NODE),
    (node(6), NODE),
    (node(7), NODE),
];
const NODES: &[Map] = &[
    node(0),
    node(1),
    node(2),
    node(3),
    node(4),
    node(5),
    node(6),
    node(7),
];

/// A node's depth, premultiplied colour and transmittance, as `glsl/multi_layer/node.glsl` packs them.
const NODE: Holds = Holds::Exactly(Format::Rgba32Ui);

/// A node, the nearest with number 0.
const fn node(number: u32) -> Map {
    Map::numbered("node", number)
}

const ALL_NODES: Target = Target("nodes");
/// A copy of the opaque depth, because a map that is looked up must not be part of the framebuffer.
const HIDING: Map = Map::named("hiding depth");
/// Fragments are tested for depth, and write images only.
const NO_COLORS: Target = Target("no colors");
const SHADERS: &[Shader] = &[stage::SURFACE, BEGIN, INSERTION, FRONT_TO_BACK];
const BEGIN: Shader = Shader("multi_layer/begin");
const INSERTION: Shader = Shader("multi_layer/insert");
const FRONT_TO_BACK: Shader = Shader("multi_layer/composite");
const TAKEN: Shader = Shader("multi_layer/taken");
const HAVE_TAKEN: Query = Query("have taken a node");
