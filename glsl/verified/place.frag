#version 430 core
// What the list of a marked pixel was resolved to.
// vertex: screen.vert

#include "a_buffer/band.glsl"
#include "verified/number.glsl"
#include "verified/list.glsl"

layout(binding = 3) uniform sampler2D resolved;

out vec4 color;

void main() {
    color = texelFetch(resolved, place_of_list(list_number()), 0);
}
