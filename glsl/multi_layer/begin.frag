#version 450 core
// Multi-layer alpha blending: every node is empty.
// vertex: screen.vert

#include "multi_layer/node.glsl"

layout(location = 0) out uvec4 nodes[NODES];

void main() {
    for (int i = 0; i < NODES; i++) {
        nodes[i] = texel_of(NOTHING);
    }
}
