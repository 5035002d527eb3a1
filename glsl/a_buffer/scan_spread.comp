#version 430 core
// Prefix scan, downwards: each number becomes the sum of those before it. The level above already holds that sum for
// each CHUNK-th; the uppermost level has a single number, before which there is nothing.

layout(local_size_x = GROUP) in;

layout(std430, binding = 0) buffer Lower {
    uint lower[];
};
layout(std430, binding = 1) readonly buffer Upper {
    uint upper[];
};

uniform uint count;    // of the lower level
uniform bool uppermost;

void main() {
    uint first = gl_GlobalInvocationID.x * uint(CHUNK);
    if (first < count) {
        uint before = uppermost ? 0u : upper[gl_GlobalInvocationID.x];
        for (uint i = first; i < min(first + uint(CHUNK), count); ++i) {
            uint here = lower[i];
            lower[i] = before;
            before += here;
        }
    }
}
