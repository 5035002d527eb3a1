#version 430 core
// What lies at the upper bound, unless that is the opaque depth.

#include "common/clip.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(z == upper_bound() && z < opaque_depth())) {
        discard;
    }
    color = premultiplied_color();
}
