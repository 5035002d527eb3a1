#version 430 core
// The counts of an image's pixels, one after the other, for the prefix scan.

layout(local_size_x = TILE, local_size_y = TILE) in;

layout(binding = 1) uniform sampler2D complexity;
layout(std430, binding = 0) writeonly buffer Counts {
    uint counts[];
};

uniform uvec2 size;

void main() {
    uvec2 here = gl_GlobalInvocationID.xy;
    if (all(lessThan(here, size))) {
        counts[here.y * size.x + here.x] = uint(texelFetch(complexity, ivec2(here), 0).r);
    }
}
