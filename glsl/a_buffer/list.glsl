// Walking a pixel's Fragment List. One way for each memory manager (Lindholm et al. 2015, figure 4).

layout(binding = 1) uniform usampler2D counter;
layout(binding = 3) uniform usamplerBuffer records;

// How many fragments the pixel has.
uint list_length() {
    return texelFetch(counter, ivec2(gl_FragCoord.xy), 0).r;
}

#if MANAGER == FFB
#include "a_buffer/fixed.glsl"
uint list_first() {
    return fixed_first();
}
uint list_next(uint at) {
    return at + fixed_stride();
}
#elif MANAGER == DFB
layout(std430, binding = 2) readonly buffer Offsets {
    uint base_offset[];
};
uint list_first() {
    return base_offset[pixel()];
}
uint list_next(uint at) {
    return at + 1u;
}
#else
layout(binding = 2) uniform usampler2D anchor;
layout(binding = 4) uniform usamplerBuffer next;
uint list_first() {
    return texelFetch(anchor, ivec2(gl_FragCoord.xy), 0).r - 1u;
}
uint list_next(uint at) {
    return texelFetch(next, int(at)).r - 1u;
}
#endif

uvec4 list_head(uint at) {
    return texelFetch(records, int(at * WORDS));
}

// Of the record at `at`, of which `head` has been read.
vec4 list_color(uint at, uvec4 head) {
#if FLOAT_COLOR
    return uintBitsToFloat(texelFetch(records, int(at * WORDS + 1u)));
#else
    return vec4(unpackHalf2x16(head.z), unpackHalf2x16(head.w));
#endif
}
