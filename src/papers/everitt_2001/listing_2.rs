//! Listing 2: NV_texture_shader computes window z from texture coordinates, in the same way in which the shadow lookup
//! will compute the depth that it compares.

use crate::steps;
use crate::steps::{Amendment, Dialect, Kind, Listing, gl::*};

/// Listing 2, line by line.
pub const LISTING_2: Listing = Listing {
    title: "Depth replace texture shader for use in depth peeling",
    source: "Everitt 2001, Listing 2",
    dialect: Dialect::Source,
    steps: steps! {
        printed;
        glActiveTextureARB(GL_TEXTURE0_ARB);
        bind_simple_1x1_uhilo();
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, LOOK_UP_TEXTURE_2D);
        line "";
        line "matrix4f m;";
        glActiveTextureARB(GL_TEXTURE1_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_DOT_PRODUCT_NV);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_PREVIOUS_TEXTURE_INPUT_NV, FROM_TEXTURE0_ARB);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glLoadIdentity();
        spelt "eye_linear_texgen();  // set EYE_LINEAR texgen with identity planes";
        eye_linear_texgen();
        spelt "texgen(true);         // enable texgen on s,t,r, and q";
        texgen(true);
        glPopMatrix();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        spelt "glTranslatef( 0, 0,.5);";
        glTranslatef(0.0, 0.0, 0.5);
        spelt "glScalef( 0, 0, .5);";
        glScalef(0.0, 0.0, 0.5);
        spelt "reshaper.apply_perspective();  // apply the camera’s perspective projection matrix";
        apply_perspective();
        glMatrixMode(GL_MODELVIEW);
        line "";
        glActiveTextureARB(GL_TEXTURE2_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_DOT_PRODUCT_DEPTH_REPLACE_NV);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_PREVIOUS_TEXTURE_INPUT_NV, FROM_TEXTURE0_ARB);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        glPushMatrix();
        glLoadIdentity();
        spelt "eye_linear_texgen();  // set EYE_LINEAR texgen with identity planes";
        eye_linear_texgen();
        spelt "texgen(true);         // enable texgen on s,t,r, and q";
        texgen(true);
        glPopMatrix();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        spelt "m(0,0) = 0;   m(0,1) = 0;   m(0,2) = 0;   m(0,3) = 0;\nm(1,0) = 0;   m(1,1) = 0;   m(1,2) = 0;   m(1,3) = 0;\nm(2,0) = 0;   m(2,1) = 0;   m(2,2) = 0;   m(2,3) = 1;  // move q to r\nm(3,0) = 0;   m(3,1) = 0;   m(3,2) = 0;   m(3,3) = 0;";
        m([[0.0; 4], [0.0; 4], [0.0, 0.0, 0.0, 1.0], [0.0; 4]]);
        glMultMatrix_m();
        spelt "reshaper.apply_perspective();  // apply the camera’s perspective projection matrix";
        apply_perspective();
        glMatrixMode(GL_MODELVIEW);
        line "";
        glActiveTextureARB(GL_TEXTURE3_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, LOOK_UP_TEXTURE_RECTANGLE_NV);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        line "";
        glActiveTextureARB(GL_TEXTURE0_ARB);
    },
};

/// Without it the shader operations have no effect.
pub const ENABLED: Amendment = Amendment {
    key: "EX01",
    kind: Kind::Filling(
        "An Invariance Issue: \"The depth computed in this texture shader replaces the fragment depth that was computed in the rasterizer\"",
    ),
    place: "Listing 2, that texture shaders are enabled",
    printed: steps! { bind_simple_1x1_uhilo(); },
    amended: steps! {
        enable_texture_shader();
        bind_simple_1x1_uhilo();
    },
    why: "texture shaders have to be enabled, and the listing enables nothing",
    test: "ex01_without_the_enabling_the_rasteriser_s_depth_is_stored",
};
