#version 450 core
// Multi-layer alpha blending: a fragment goes behind the nodes that are nearer or as near. Where that makes one node too
// many, the two farthest are merged. The nodes are the framebuffer's color maps, fetched in the order of submission; each
// is written in any case, because drivers do not keep one that is only read.

#extension GL_EXT_shader_framebuffer_fetch : require

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"
#include "multi_layer/node.glsl"

layout(location = 0) inout uvec4 nodes[NODES];    // nearest first

void main() {
    STORE_DEPTH
    vec4 straight = surface_color();
    uvec4 farther = texel_of(Node(floatBitsToUint(FRAGMENT_DEPTH), straight.rgb * straight.a, 1.0 - straight.a));
    bool moves = false;    // from its place on, each node moves by one, those of equal depth, too
    for (int i = 0; i < NODES; i++) {
        uvec4 here = nodes[i];
        moves = moves || farther.x < here.x;
        nodes[i] = moves ? farther : here;
        farther = moves ? here : farther;
    }
    if (farther.x != NO_DEPTH) {
        nodes[NODES - 1] = texel_of(merged(node_of(nodes[NODES - 1]), node_of(farther)));
    }
}
