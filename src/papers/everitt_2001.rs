//! Cass Everitt, *Interactive Order-Independent Transparency*, NVIDIA, 15 May 2001.
//!
//! Listing 1 is the algorithm, written for an OpenGL with two depth units; [`DepthUnits`](crate::steps::DepthUnits)
//! runs it on a real one, as "Shadow Mapping as Depth Test" proposes. The paper gives compositing in a sentence
//! ("Putting It All Together"); it stands here as [`COMPOSITE`].

mod invariance;
mod listing_2;
mod shadow;

pub use invariance::{REPLACED, WINDOW_Z};
pub use listing_2::LISTING_2;
pub use shadow::SHADOW_AS_DEPTH_TEST;

use super::stage::LAYER;
use crate::steps;
use crate::steps::{Amendment, Dialect, Listing, Map, gl::*};

/// Listing 1, line by line.
pub const LISTING_1: Listing = Listing {
    title: "Pseudocode for depth peeling using multiple simultaneous depth buffers",
    source: "Everitt 2001, Listing 1",
    dialect: Dialect::Phrases,
    steps: steps! {
        for (i in 0..num_passes) {
            clear color buffer;
            A = i % 2;
            B = (i + 1) % 2;
            depth unit 0: {
                if (i == 0) {
                    disable depth test;
                } else {
                    enable depth test;
                }
                bind buffer A;
                disable depth writes;
                set depth func to GREATER;
            }
            depth unit 1: {
                bind buffer B;
                clear depth buffer;
                enable depth writes;
                enable depth test;
                set depth func to LESS;
            }
            render scene;
            save color buffer RGBA as layer i;
        }
    },
};

/// "Putting It All Together": the layers as viewport-sized textured quads, back to front.
pub const COMPOSITE: Listing = Listing {
    title: "The layers, back to front, as viewport-sized textured quads",
    source: "Everitt 2001, Putting It All Together",
    dialect: Dialect::Calls,
    steps: steps! {
        glDisable(DEPTH_TEST);
        glEnable(BLEND);
        glBlendFunc(SRC_ALPHA, ONE_MINUS_SRC_ALPHA);
        glUseProgram(LAYER);
        glActiveTexture(2);
        for (i in num_layers..0) {
            glBindTexture(LAYER_I);
            drawScreen();
        }
        glDisable(BLEND);
    },
};

/// The printed blend function also blends alpha by alpha: over an opaque background the image's own alpha becomes
/// `a² + 1 - a`, less than 1 wherever there is a layer. On a screen nobody sees it; in a file everybody does.
pub const ALPHA: Amendment = Amendment {
    key: "E12",
    place: "Putting It All Together, the blending function",
    printed: steps! { glBlendFunc(SRC_ALPHA, ONE_MINUS_SRC_ALPHA); },
    amended: steps! { glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA); },
    why: "alpha is covered by alpha, not by its square",
    test: "e12_the_printed_blend_function_leaves_an_opaque_image_translucent",
};

const LAYER_I: Map = Map::at("layer", "i");
