#version 430 core
// A surface over those that were drawn before it, straight alpha, for (SRC_ALPHA, ONE_MINUS_SRC_ALPHA). The depth test
// proves the order, so what an opaque surface hides must not come to it.
// defines: method

vec4 surface_color();    // surface/unlit.frag, surface/lit.frag or surface/mixed.frag

#include "verified/hidden.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    SKIP_WHAT_IS_HIDDEN
    color = surface_color();
}
