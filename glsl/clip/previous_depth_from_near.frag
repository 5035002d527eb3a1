#version 430 core
// Carr et al. 2008, section 6: white, and the depth as alpha; in [lower, upper).

#include "common/clip.glsl"

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(lower_bound() <= z && z < upper_bound())) {
        discard;
    }
    color = vec4(1.0, 1.0, 1.0, z);
}
