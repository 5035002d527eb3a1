// Walking a pixel's Fragment List. One way for each memory manager (Lindholm et al. 2015, figure 4).
// defines: method

layout(binding = 1) uniform usampler2D counter;
layout(binding = 3) uniform usamplerBuffer records;

// How many fragments the pixel has.
#if OFFSETS
#include "a_buffer/offset.glsl"
uint list_length() {
    uint base = base_offset();
    uint end = texelFetch(counter, ivec2(gl_FragCoord.xy), 0).r;
    // Next to the band, where its neighbours are shaded along with it, neither means anything; but loops have to end.
    return end > base ? min(end - base, band.layers) : 0u;
}
#elif MANAGER == FFB
uint list_length() {
    // The counter goes on where the buffer ends.
    return min(texelFetch(counter, ivec2(gl_FragCoord.xy), 0).r, band.layers);
}
#else
uint list_length() {
    return texelFetch(counter, ivec2(gl_FragCoord.xy), 0).r;
}
#endif

#if MANAGER == FFB
#include "a_buffer/fixed.glsl"
uint list_first() {
    return fixed_first();
}
uint list_next(uint at) {
    return at + fixed_stride();
}
#elif MANAGER == DFB
uint list_first() {
    return base_offset();
}
uint list_next(uint at) {
    return at + 1u;
}
#else
layout(binding = 4) uniform usamplerBuffer next;
#if OFFSETS
// The counter says one more than the newest node, which is what an anchor says.
uint list_first() {
    return texelFetch(counter, ivec2(gl_FragCoord.xy), 0).r - 1u;
}
#else
layout(binding = 2) uniform usampler2D anchor;
uint list_first() {
    return texelFetch(anchor, ivec2(gl_FragCoord.xy), 0).r - 1u;
}
#endif
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
#elif FIXED_COLOR
    uvec3 alpha = head.yzw >> 24;
    return vec4(uvec4(head.yzw & 0xFFFFFFu, alpha.x | alpha.y << 8 | alpha.z << 16)) / LARGEST;
#else
    return vec4(unpackHalf2x16(head.z), unpackHalf2x16(head.w));
#endif
}
