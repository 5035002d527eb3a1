#version 430 core
// Dual depth peeling, before the first peel: where the nearest and the farthest fragments are. No colour is needed.

out vec2 depth;

vec4 surface_color();    // linked with every surface

#include "common/fragment_depth.glsl"

void main() {
    STORE_DEPTH
    depth = vec2(-FRAGMENT_DEPTH, FRAGMENT_DEPTH);
}
