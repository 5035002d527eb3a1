#version 450 core
// Algorithm 2, lines 36 to 40: an unbroken run ends at z2.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"

void main() {
    STORE_DEPTH
    BEGIN_FRAGMENT
    float z = FRAGMENT_DEPTH;
    if (peel.r < z && z < tight_bound()) {
        composite_fragment();
    }
    END_FRAGMENT
}
