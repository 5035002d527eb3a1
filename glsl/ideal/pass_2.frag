#version 450 core
// Algorithm 2, lines 36 to 40.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"

void main() {
    BEGIN_FRAGMENT
    float z = gl_FragCoord.z;
    if (peel.r < z && z < depths.z) {
        composite_fragment();
    }
    END_FRAGMENT
}
