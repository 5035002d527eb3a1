#version 430 core
// What lies at the upper bound, whatever bounds it.

#include "common/clip.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(z == upper_bound())) {
        discard;
    }
    color = premultiplied_color();
}
