#version 450 core
// Multi-layer alpha blending: draws the pixels in which a node is filled. A query counts them.
// vertex: screen.vert

#include "multi_layer/node.glsl"

layout(binding = 0) uniform usampler2D node;

void main() {
    if (texelFetch(node, ivec2(gl_FragCoord.xy), 0).x == NO_DEPTH) {
        discard;
    }
}
