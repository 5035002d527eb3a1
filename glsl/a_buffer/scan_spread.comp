#version 430 core
// Prefix scan, downwards: each number becomes the sum of those before it. The level above already holds that sum for
// each 64th; the uppermost level has a single number, before which there is nothing.

layout(local_size_x = 256) in;

layout(std430, binding = 0) buffer Lower {
    uint lower[];
};
layout(std430, binding = 1) readonly buffer Upper {
    uint upper[];
};

uniform uint count;    // of the lower level
uniform bool uppermost;

void main() {
    uint first = gl_GlobalInvocationID.x * 64u;
    if (first < count) {
        uint before = uppermost ? 0u : upper[gl_GlobalInvocationID.x];
        for (uint i = first; i < min(first + 64u, count); ++i) {
            uint here = lower[i];
            lower[i] = before;
            before += here;
        }
    }
}
