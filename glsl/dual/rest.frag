#version 430 core
// For an occlusion query: the fragments that are left to peel.

vec4 surface_color();    // linked with every surface

#include "common/dual.glsl"

out vec4 color;

void main() {
    vec2 bounds = nearest_and_farthest();
    if (gl_FragCoord.z < bounds.x || gl_FragCoord.z > bounds.y) {
        discard;
    }
    color = vec4(1.0);
}
