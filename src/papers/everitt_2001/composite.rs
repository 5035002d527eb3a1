//! "Putting It All Together", where the paper gives compositing in a sentence.

use crate::papers::stage::LAYER;
use crate::steps;
use crate::steps::{Amendment, Dialect, Kind, Listing, Map, Resources, gl::*};

/// "Putting It All Together": the layers as viewport-sized textured quads, back to front.
pub const COMPOSITE: Listing = Listing {
    title: "The layers, back to front, as viewport-sized textured quads",
    source: "Everitt 2001, Putting It All Together",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "the quads are not tested";
        glDisable(DEPTH_TEST);
        prose "for back-to-front compositing a (GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA) blending function is used";
        glEnable(BLEND);
        glBlendFunc(SRC_ALPHA, ONE_MINUS_SRC_ALPHA);
        prose "rendering each layer as viewport-sized textured quad does this";
        glUseProgram(LAYER);
        edition "the shader looks layers up on unit 2";
        glActiveTexture(2);
        prose "rendering each layer as viewport-sized textured quad does this";
        for (i in num_layers..0) {
            glBindTexture(LAYER_I);
            drawScreen();
        }
        edition "nothing else blends";
        glDisable(BLEND);
    },
};

/// The printed blend function also blends alpha by alpha: over an opaque background the image's own alpha becomes `a² +
/// 1 - a`, less than 1 wherever there is a layer. On a screen this is invisible, but not in a file.
pub const ALPHA: Amendment = Amendment {
    key: "EX07",
    kind: Kind::Correction,
    place: "Putting It All Together, the blending function",
    printed: steps! { glBlendFunc(SRC_ALPHA, ONE_MINUS_SRC_ALPHA); },
    amended: steps! { glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA); },
    why: "alpha is covered by alpha, not by its square",
    test: "e12_the_printed_blend_function_leaves_an_opaque_image_translucent",
};

/// What [`COMPOSITE`] takes for granted.
pub const COMPOSITING: Resources = Resources {
    made: &[LAYER_I],
    variables: &["num_layers"],
    ..Resources::NONE
};

/// A layer that was kept.
pub const LAYER_I: Map = Map::at("layer", "i");
