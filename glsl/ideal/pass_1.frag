#version 450 core
// Algorithm 2, lines 13 to 34: what lies on the opaque surface is hidden.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"
#include "common/ideal_pass_1.glsl"

void main() {
    STORE_DEPTH
    BEGIN_FRAGMENT
    float z = FRAGMENT_DEPTH;
    if (!peel_fragment(z) && z == peel.r && z < opaque_depth()) {
        composite_fragment();
    }
    END_FRAGMENT
}
