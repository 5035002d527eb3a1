#version 430 core
// What lies behind the transparent surfaces of a marked pixel goes where its list will be resolved.
// vertex: screen.vert

#include "a_buffer/band.glsl"
#include "verified/number.glsl"
#include "verified/list.glsl"

layout(early_fragment_tests) in;

layout(binding = 3) uniform sampler2D behind;
layout(binding = 0, rgba32f) writeonly uniform image2D resolved;

void main() {
    imageStore(resolved, place_of_list(list_number()), texelFetch(behind, ivec2(gl_FragCoord.xy), 0));
}
