#version 430 core
// A surface as it is: opaque geometry, and the methods that blend.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    color = surface_color();
}
