#version 430 core
// Counts the fragments of the pixels that have a list.
// defines: method

vec4 surface_color();    // surface/unlit.frag, surface/lit.frag or surface/mixed.frag; shading is disabled

#include "verified/hidden.glsl"
#include "verified/anchor.glsl"

layout(early_fragment_tests) in;

layout(std430, binding = 0) buffer Counts {
    uint counts[];
};

void main() {
    SKIP_WHAT_IS_HIDDEN
    atomicAdd(counts[list_number()], 1u);
}
