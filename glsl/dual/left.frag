#version 430 core
// For an occlusion query: the pixels in which some fragment is left to peel.
// vertex: screen.vert

#include "common/dual.glsl"

out vec4 color;

void main() {
    vec2 bounds = nearest_and_farthest();
    if (bounds.x > bounds.y) {
        discard;
    }
    color = vec4(1.0);
}
