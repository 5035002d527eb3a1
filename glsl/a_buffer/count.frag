#version 430 core
// The depth complexity image as the paper makes it: the pixels of an integer image act as atomic counters.

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag; shading is disabled

layout(early_fragment_tests) in;
layout(binding = 0, r32ui) uniform uimage2D complexity;

void main() {
    imageAtomicAdd(complexity, ivec2(gl_FragCoord.xy), 1u);
}
