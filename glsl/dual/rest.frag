#version 430 core
// For an occlusion query: the fragments that are left to peel.

vec4 surface_color();    // linked with every surface

#include "common/fragment_depth.glsl"

#include "common/dual.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    vec2 bounds = nearest_and_farthest();
    if (FRAGMENT_DEPTH < bounds.x || FRAGMENT_DEPTH > bounds.y) {
        discard;
    }
    color = vec4(1.0);
}
