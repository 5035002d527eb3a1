#version 450 core
#extension GL_EXT_shader_framebuffer_fetch : require
// Fill Step with ordered fragments: the pixel's counter, and with PPLL its anchor, are colours of the framebuffer, which
// a fragment reads and writes in its turn. No atomics.

layout(early_fragment_tests) in;

#include "a_buffer/pixel.glsl"
#include "a_buffer/record.glsl"
#include "a_buffer/source.glsl"
#include "a_buffer/place.glsl"

layout(location = 0) inout uint counter;
#if MANAGER == PPLL
layout(location = 1) inout uint anchor;
layout(std430, binding = 1) writeonly buffer Next {
    uint next[];
};
#endif
layout(std430, binding = 0) writeonly buffer Records {
    uvec4 records[];
};

void main() {
    uint at = place(counter);
    counter += 1u;
    if (at < band.capacity) {
        vec4 color = source_color();
        records[at * WORDS] = head_of(source_depth(), source_id(), color);
#if FLOAT_COLOR
        records[at * WORDS + 1u] = floatBitsToUint(color);
#endif
#if MANAGER == PPLL
        next[at] = anchor;
        anchor = at + 1u;
#endif
    }
}
