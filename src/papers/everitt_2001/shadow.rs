//! "Shadow Mapping as Depth Test", as the OpenGL of 2001 does it. The paper describes it in prose.
//!
//! The shadow map has the camera's own orientation and resolution, so its texture matrix is the camera's projection with
//! scale and bias from clip to texture space. The comparison of r/q goes into alpha, and the alpha test discards. Modulation
//! leaves a fragment that passes its own alpha. A fragment whose alpha is 0 never passes, but it is invisible anyway.
//!
//! How the comparison comes into alpha, and which texture unit 3 looks up, the prose does not say, and Listing 2 says
//! otherwise. The fillings do.

use crate::steps;
use crate::steps::{
    Amendment, CombinerComponent, CombinerMapping, CombinerRegister, CombinerVariable, Dialect,
    Kind, Listing, Number, gl::*,
};

/// Before the peels: texture unit 3 compares r/q with the shadow map that is bound to it.
pub const SHADOW_AS_DEPTH_TEST: Listing = Listing {
    title: "Shadow mapping from the camera's own position, its result in alpha",
    source: "Everitt 2001, Shadow Mapping as Depth Test",
    dialect: Dialect::Source,
    steps: steps! {
        edition "the unit of Listing 2";
        glActiveTextureARB(GL_TEXTURE3_ARB);
        prose "the shadow mapping comparison sets a fragment color attribute";
        compare_r_to_texture(true);
        prose "we make the orientation and resolution of the shadow map identical to that of the camera";
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glLoadIdentity();
        eye_linear_texgen();
        texgen(true);
        glPopMatrix();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glTranslatef(0.5, 0.5, 0.5);
        glScalef(0.5, 0.5, 0.5);
        apply_perspective();
        glMatrixMode(GL_MODELVIEW);
        prose "use alpha test to discard fragments that fail the \"depth test\" we have chosen";
        glAlphaFunc(GREATER, 0.0);
    },
};

/// What fills the silence of [`SHADOW_AS_DEPTH_TEST`], with shadow maps in textures of two dimensions.
pub const SHADOW_FILLINGS: [Amendment; 3] = [INTO_ALPHA, MODULATED, LOOKED_UP_AS_2D];

/// The same with shadow maps in rectangle textures.
pub const RECTANGLE_FILLINGS: [Amendment; 3] = [INTO_ALPHA, MODULATED, TEXELS];

/// SGIX_shadow, which the paper names, makes a luminance of the comparison.
pub const INTO_ALPHA: Amendment = Amendment {
    key: "EX04",
    kind: Kind::Filling(RESULTS_IN_ALPHA),
    place: "how the comparison's result comes into alpha",
    printed: steps! { compare_r_to_texture(true); },
    amended: steps! {
        compare_r_to_texture(true);
        depth_texture_mode(GL_ALPHA);
    },
    why: "SGIX_shadow's result is a luminance; ARB_depth_texture of 2002 has this way into alpha",
    test: "ex04_a_luminance_leaves_alpha_as_it_is_and_nothing_is_peeled",
};

/// Listing 2 gives unit 3 the environment GL_NONE, which would be right if register combiners carried the result on. The paper
/// does not mention them.
pub const MODULATED: Amendment = Amendment {
    key: "EX02",
    kind: Kind::Filling(RESULTS_IN_ALPHA),
    place: "Listing 2, unit 3, by which environment the result reaches the fragment",
    printed: steps! {
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
    },
    amended: steps! {
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
    },
    why: "Listing 2 leaves unit 3 an environment by which nothing of the comparison reaches alpha",
    test: "ex02_by_unit_3_s_printed_environment_nothing_is_peeled",
};

/// Listing 2 lets unit 3 look up a rectangle texture, and generates no coordinates for it. From 0 to 1 they are those of a
/// texture of two dimensions, which has the same texels.
pub const LOOKED_UP_AS_2D: Amendment = Amendment {
    key: "EX03",
    kind: Kind::Filling(PROJECTED),
    place: "Listing 2, unit 3, in which coordinates the shadow map is looked up",
    printed: steps! { glAlphaFunc(GREATER, 0.0); },
    amended: steps! {
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, LOOK_UP_TEXTURE_2D);
        glAlphaFunc(GREATER, 0.0);
    },
    why: "Listing 2 looks up a rectangle texture, and these coordinates go from 0 to 1",
    test: "ex03_with_coordinates_from_0_to_1_the_printed_rectangle_does_not_peel",
};

/// In place of [`LOOKED_UP_AS_2D`]: the coordinates count texels. Before it runs, `width` and `height` are set.
pub const TEXELS: Amendment = Amendment {
    key: "EX03",
    kind: Kind::Filling(PROJECTED),
    place: "Listing 2, unit 3, in which coordinates the shadow map is looked up",
    printed: steps! { glTranslatef(0.5, 0.5, 0.5); },
    amended: steps! {
        scale_by(Number::Variable("width"), Number::Variable("height"));
        glTranslatef(0.5, 0.5, 0.5);
    },
    why: "Listing 2 looks up a rectangle texture, whose coordinates count texels",
    test: "ex03_with_coordinates_from_0_to_1_the_printed_rectangle_does_not_peel",
};

/// In place of [`INTO_ALPHA`] and [`MODULATED`], with [`SGIX_LEQUAL`]: what a GeForce3 had in 2001. The luminance's inverse goes
/// into alpha through register combiners, so what SGIX_shadow does not pass is kept, which is what lies behind.
pub const COMBINED: Amendment = Amendment {
    key: "EX04",
    kind: Kind::Edition,
    place: "Shadow Mapping as Depth Test",
    printed: steps! { compare_r_to_texture(true); },
    amended: steps! {
        compare_r_to_texture(true);
        enable_register_combiners();
        glCombinerInputNV(CombinerVariable::A, CombinerRegister::Texture3, CombinerMapping::Invert, CombinerComponent::Blue);
        glCombinerInputNV(CombinerVariable::B, CombinerRegister::PrimaryColor, CombinerMapping::Identity, CombinerComponent::Alpha);
    },
    why: "SGIX_shadow's result is a luminance; register combiners carry its inverse into alpha",
    test: "ex04_sgix_shadow_peels_by_what_lequal_does_not_pass",
};

/// The same for [`SGIX_GEQUAL`]: the luminance as it is.
pub const COMBINED_AS_IT_IS: Amendment = Amendment {
    amended: steps! {
        compare_r_to_texture(true);
        enable_register_combiners();
        glCombinerInputNV(CombinerVariable::A, CombinerRegister::Texture3, CombinerMapping::Identity, CombinerComponent::Blue);
        glCombinerInputNV(CombinerVariable::B, CombinerRegister::PrimaryColor, CombinerMapping::Identity, CombinerComponent::Alpha);
    },
    why: "SGIX_shadow's result is a luminance; register combiners carry it into alpha",
    test: "ex04_by_gequal_equal_depths_pass_and_every_layer_is_the_first",
    ..COMBINED
};

/// To Listing 1, with [`COMBINED`]: SGIX_shadow has no GREATER. What LEQUAL does not pass is what GREATER passes.
pub const SGIX_LEQUAL: Amendment = Amendment {
    key: "EX04",
    kind: Kind::Edition,
    place: "Listing 1, set depth func to GREATER",
    printed: steps! { set depth func to GREATER; },
    amended: steps! { set depth func to LEQUAL; },
    why: "SGIX_shadow compares by LEQUAL and GEQUAL only",
    test: "ex04_sgix_shadow_peels_by_what_lequal_does_not_pass",
};

/// The same without an inverse. A fragment passes the comparison with its own depth, so nothing is peeled.
pub const SGIX_GEQUAL: Amendment = Amendment {
    amended: steps! { set depth func to GEQUAL; },
    test: "ex04_by_gequal_equal_depths_pass_and_every_layer_is_the_first",
    ..SGIX_LEQUAL
};

const RESULTS_IN_ALPHA: &str = "Shadow Mapping as Depth Test: \"we write the results of the shadow mapping comparison to fragment alpha\"";

const PROJECTED: &str = "Shadow Mapping as Depth Test: \"we make the orientation and resolution of the shadow map identical to that of the camera\"";
