#version 450 core
// Algorithm 2, lines 7 to 12, as printed.
// vertex: screen.vert

#include "common/ideal.glsl"

void main() {
    BEGIN_FRAGMENT
    peel = vec4(depths.z);
    depths = vec4(opaque_depth(), opaque_depth(), depths.z, 0.0);
    END_FRAGMENT
}
