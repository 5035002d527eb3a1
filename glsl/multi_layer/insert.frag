#version 450 core
// Multi-layer alpha blending: a fragment becomes a node, behind the nodes that are nearer or as near. If that makes one node
// too many, the two farthest nodes are merged.
//
// By default the nodes are the framebuffer's color maps, which fragments fetch in the order of submission. The shader writes
// each of them in any case, because drivers do not keep one that is only read. With IMAGES the nodes are images, which the
// shader loads and stores within an interlock.
// defines: method

#if IMAGES
#include "common/interlock.glsl"
#else
#extension GL_EXT_shader_framebuffer_fetch : require
#endif

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "multi_layer/node.glsl"

#if IMAGES
#include "common/skip_hidden.glsl"
layout(binding = 0, rgba32ui) coherent uniform uimage2D node_images[NODES];
uvec4 nodes[NODES];    // nearest first
#else
#include "common/fragment_depth.glsl"
layout(location = 0) inout uvec4 nodes[NODES];    // nearest first
#endif

void insert(uvec4 farther) {
    bool moves = false;    // from the fragment's place on, each node moves by one; those of equal depth do, too
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

void main() {
    STORE_DEPTH
    vec4 straight = surface_color();
    uvec4 node = texel_of(Node(floatBitsToUint(FRAGMENT_DEPTH), straight.rgb * straight.a, 1.0 - straight.a));
#if IMAGES
    SKIP_HIDDEN
    ivec2 here = ivec2(gl_FragCoord.xy);
    BEGIN_INTERLOCK
    for (int i = 0; i < NODES; i++) {
        nodes[i] = imageLoad(node_images[i], here);
    }
    insert(node);
    for (int i = 0; i < NODES; i++) {
        imageStore(node_images[i], here, nodes[i]);
    }
    END_INTERLOCK
#else
    insert(node);
#endif
}
