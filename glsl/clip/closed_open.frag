#version 430 core
// What lies between the bounds or at the lower one: [lower, upper).

#include "common/clip.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(lower_bound() <= z && z < upper_bound())) {
        discard;
    }
    color = premultiplied_color();
}
