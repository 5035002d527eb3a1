#version 430 core
// One for each fragment, to be added up by blending.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag: it completes the program, and is not asked

#include "common/fragment_depth.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    color = vec4(1.0);
}
