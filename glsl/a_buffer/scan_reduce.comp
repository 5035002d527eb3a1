#version 430 core
// Prefix scan, upwards: the sum of each CHUNK numbers of one level is one number of the next.

layout(local_size_x = GROUP) in;

layout(std430, binding = 0) readonly buffer Lower {
    uint lower[];
};
layout(std430, binding = 1) writeonly buffer Upper {
    uint upper[];
};

uniform uint count;    // of the lower level

void main() {
    uint first = gl_GlobalInvocationID.x * uint(CHUNK);
    if (first < count) {
        uint sum = 0u;
        for (uint i = first; i < min(first + uint(CHUNK), count); ++i) {
            sum += lower[i];
        }
        upper[gl_GlobalInvocationID.x] = sum;
    }
}
