#version 450 core
// Algorithm 2, lines 36 to 40.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"

void main() {
    STORE_DEPTH
    BEGIN_FRAGMENT
    float z = FRAGMENT_DEPTH;
    if (peel.r < z && z < depths.z) {
        composite_fragment();
    }
    END_FRAGMENT
}
