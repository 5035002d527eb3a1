#version 430 core
// verified/surface.frag, where triangles are drawn in pieces.
// vertex: verified/pieces.vert
// defines: method

vec4 surface_color();    // surface/unlit.frag, surface/lit.frag or surface/mixed.frag

#include "verified/hidden.glsl"
#include "verified/pieces.glsl"

uniform uint first_triangle;

in float along;
out vec4 color;

void main() {
    STORE_DEPTH
    if (!is_in_piece(first_triangle + uint(gl_PrimitiveID), along)) {
        discard;
    }
    SKIP_WHAT_IS_HIDDEN
    color = surface_color();
}
