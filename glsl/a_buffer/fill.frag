#version 430 core
// Fill Step with atomics: each fragment counts its pixel's counter up, finds its place and writes its record there.
// defines: method

#include "a_buffer/pixel.glsl"
#include "a_buffer/record.glsl"
#include "a_buffer/source.glsl"
#if MANAGER == PPLL
#include "a_buffer/pool.glsl"
#else
#include "a_buffer/place.glsl"
#endif

layout(binding = 0, r32ui) uniform uimage2D counter;
#if MANAGER == PPLL
layout(binding = 1, r32ui) uniform uimage2D anchor;
layout(std430, binding = 1) writeonly buffer Next {
    uint next[];
};
#endif
layout(std430, binding = 0) writeonly buffer Records {
    uvec4 records[];
};

#if MARKED
#include "verified/number.glsl"
#include "verified/list.glsl"
#endif

void main() {
    STORE_DEPTH
    SKIP_HIDDEN
#if MARKED
    ivec2 here = place_of_list(list_number());
    if (!is_in_band(here)) {
        discard;
    }
#else
    ivec2 here = ivec2(gl_FragCoord.xy);
#endif
    uint at = place(imageAtomicAdd(counter, here, 1u));
    if (at < band.capacity) {
        vec4 color = source_color();
        records[at * WORDS] = head_of(source_depth(), source_id(), color);
#if FLOAT_COLOR
        records[at * WORDS + 1u] = floatBitsToUint(color);
#endif
#if MANAGER == PPLL
        next[at] = imageAtomicExchange(anchor, here, at + 1u);
#endif
    }
}
