#version 450 core
// Algorithm 2, lines 7 to 12: z3 goes to the opaque depth, so that a pixel with nothing left ends there.
// vertex: screen.vert

#include "common/ideal.glsl"

void main() {
    BEGIN_FRAGMENT
    peel = vec4(depths.z);
    depths = vec4(vec3(opaque_depth()), 0.0);
    END_FRAGMENT
}
