#version 450 core
// Algorithm 2's gChanged: pass 1 has found something at this pixel.
// vertex: screen.vert

#include "common/ideal.glsl"

void main() {
    READ_FRAGMENT
    if (depths.x >= opaque_depth()) {
        discard;
    }
}
