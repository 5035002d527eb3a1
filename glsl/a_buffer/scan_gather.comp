#version 430 core
// The counts of a band's pixels, one after the other, for the prefix scan.

layout(local_size_x = 16, local_size_y = 16) in;

#include "a_buffer/band.glsl"

layout(binding = 1) uniform sampler2D complexity;
layout(std430, binding = 0) writeonly buffer Counts {
    uint counts[];
};

uniform uint rows;

void main() {
    uvec2 here = gl_GlobalInvocationID.xy;
    if (here.x < band.width && here.y < rows) {
        float count = texelFetch(complexity, ivec2(here.x, here.y + band.first_row), 0).r;
        counts[here.y * band.width + here.x] = uint(count);
    }
}
