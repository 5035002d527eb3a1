#version 430 core
// Sorted surfaces between two peels: (lower, upper); line 17 of Algorithm 1.

#include "common/clip.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(lower_bound() < z && z < upper_bound())) {
        discard;
    }
    color = premultiplied_color();
}
