#version 430 core
// The depth complexity image as the paper makes it: the pixels of an integer image act as atomic counters.

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag; shading is disabled

#include "common/skip_hidden.glsl"

layout(binding = 0, r32ui) uniform uimage2D complexity;

void main() {
    STORE_DEPTH
    SKIP_HIDDEN
    imageAtomicAdd(complexity, ivec2(gl_FragCoord.xy), 1u);
}
