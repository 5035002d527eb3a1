// The part of NV_texture_shader that Listing 2 uses. A dot product is that of a stage's (s, t, r) with the previous
// texture's result; an unsigned HILO texel's third component is 1 by definition.

uniform bool replaces_depth;              // texture shaders are enabled, and both stages are set up
uniform sampler2D unsigned_hilo;
uniform int dot_product;                  // the stage of GL_DOT_PRODUCT_NV
uniform int dot_product_depth_replace;    // the stage after it

vec3 hilo() {
    return vec3(texelFetch(unsigned_hilo, ivec2(0), 0).rg, 1.0);
}

float depth_replace() {
    float r1 = dot(tex_coord[dot_product].stp, hilo());
    float r2 = dot(tex_coord[dot_product_depth_replace].stp, hilo());
    // "In exactly the same way that we compute it when making the comparison": a projective lookup multiplies by the
    // reciprocal of q. A division rounds once less, and mis-peels.
    return r1 * (1.0 / r2);
}
