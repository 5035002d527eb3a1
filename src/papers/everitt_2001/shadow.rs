//! "Shadow Mapping as Depth Test", as the OpenGL of 2001 does it. The paper describes it in prose.
//!
//! The shadow map has the camera's own orientation and resolution, so its texture matrix is the camera's projection with
//! scale and bias from clip to texture space. The comparison of r/q goes into alpha, and the alpha test discards.
//!
//! SGIX_shadow compares by LEQUAL and GEQUAL only, and its result is a luminance. GREATER came with EXT_shadow_funcs, which
//! VTK asks for, and the way into alpha with ARB_depth_texture, both in 2002. So Listing 1 did not run like this in 2001:
//! with GEQUAL a fragment would pass the comparison with its own depth. Modulation
//! leaves a fragment that passes its own alpha. A fragment whose alpha is 0 never passes, but it is invisible anyway.

use crate::steps;
use crate::steps::{Dialect, Listing, gl::*};

/// Before the peels: texture unit 3 compares r/q with the shadow map that is bound to it.
pub const SHADOW_AS_DEPTH_TEST: Listing = Listing {
    title: "Shadow mapping from the camera's own position, its result in alpha",
    source: "Everitt 2001, Shadow Mapping as Depth Test",
    dialect: Dialect::Source,
    steps: steps! {
        edition "the unit of Listing 2";
        glActiveTextureARB(GL_TEXTURE3_ARB);
        prose "we write the results of the shadow mapping comparison to fragment alpha";
        compare_r_to_texture(true);
        edition "SGIX_shadow of 2001 has a luminance as its result; the mode came with ARB_depth_texture in 2002";
        depth_texture_mode(GL_ALPHA);
        prose "we write the results of the shadow mapping comparison to fragment alpha";
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
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
