//! Listing 2: NV_texture_shader computes window z from texture coordinates, in the same way in which the shadow lookup
//! will compute the depth that it compares.

use crate::steps;
use crate::steps::{Dialect, Listing, gl::*};

/// Listing 2, line by line. `matrix4f m;` and the comments are left out.
pub const LISTING_2: Listing = Listing {
    title: "Depth replace texture shader for use in depth peeling",
    source: "Everitt 2001, Listing 2",
    dialect: Dialect::Source,
    steps: steps! {
        glActiveTextureARB(GL_TEXTURE0_ARB);
        bind_simple_1x1_uhilo();
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, LOOK_UP_TEXTURE_2D);
        glActiveTextureARB(GL_TEXTURE1_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_DOT_PRODUCT_NV);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_PREVIOUS_TEXTURE_INPUT_NV, FROM_TEXTURE0_ARB);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glLoadIdentity();
        eye_linear_texgen();
        texgen(true);
        glPopMatrix();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glTranslatef(0.0, 0.0, 0.5);
        glScalef(0.0, 0.0, 0.5);
        apply_perspective();
        glMatrixMode(GL_MODELVIEW);
        glActiveTextureARB(GL_TEXTURE2_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GL_DOT_PRODUCT_DEPTH_REPLACE_NV);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_PREVIOUS_TEXTURE_INPUT_NV, FROM_TEXTURE0_ARB);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        glPushMatrix();
        glLoadIdentity();
        eye_linear_texgen();
        texgen(true);
        glPopMatrix();
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        m([[0.0; 4], [0.0; 4], [0.0, 0.0, 0.0, 1.0], [0.0; 4]]);
        glMultMatrix_m();
        apply_perspective();
        glMatrixMode(GL_MODELVIEW);
        glActiveTextureARB(GL_TEXTURE3_ARB);
        glTexEnvi(GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, LOOK_UP_TEXTURE_RECTANGLE_NV);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_NONE);
        glActiveTextureARB(GL_TEXTURE0_ARB);
    },
};
