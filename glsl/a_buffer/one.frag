#version 430 core
// One more: for additive blending into a count, and for the stencil buffer, which ignores it.

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag; shading is disabled

#include "common/fragment_depth.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    color = vec4(1.0);
}
