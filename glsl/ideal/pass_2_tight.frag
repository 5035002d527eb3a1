#version 450 core
// Algorithm 2, lines 36 to 40: an unbroken run ends at z2.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"

void main() {
    BEGIN_FRAGMENT
    float z = gl_FragCoord.z;
    if (peel.r < z && z < tight_bound()) {
        composite_fragment();
    }
    END_FRAGMENT
}
