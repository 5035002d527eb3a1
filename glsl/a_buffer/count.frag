#version 430 core
// The depth complexity image as the paper makes it: the pixels of an integer image act as atomic counters.

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag; shading is disabled

#include "common/fragment_depth.glsl"

#ifdef INVERSE_W
layout(binding = 5) uniform sampler2D opaque;
#else
layout(early_fragment_tests) in;
#endif
layout(binding = 0, r32ui) uniform uimage2D complexity;

void main() {
#ifdef INVERSE_W
    STORE_DEPTH
    if (FRAGMENT_DEPTH >= texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r) {
        discard;
    }
#endif
    imageAtomicAdd(complexity, ivec2(gl_FragCoord.xy), 1u);
}
