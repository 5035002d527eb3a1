#version 450 core
// Multi-layer alpha blending: composites the nodes front to back. Alpha is the transmittance of all nodes together.
// vertex: screen.vert

#include "multi_layer/node.glsl"

layout(binding = 0) uniform usampler2D nodes[NODES];

out vec4 color;

void main() {
    Node all = NOTHING;
    for (int i = 0; i < NODES; i++) {
        all = merged(all, node_of(texelFetch(nodes[i], ivec2(gl_FragCoord.xy), 0)));
    }
    color = vec4(all.color, all.transmittance);
}
