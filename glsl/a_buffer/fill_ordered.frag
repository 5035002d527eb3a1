#version 450 core
#extension GL_EXT_shader_framebuffer_fetch : require
// Fill Step with ordered fragments: the pixel's counter is a colour of the framebuffer, which a fragment reads and writes
// in its turn. No atomics.
// defines: method

#include "a_buffer/pixel.glsl"
#include "a_buffer/record.glsl"
#include "a_buffer/source.glsl"
#include "a_buffer/place.glsl"

layout(location = 0) inout uint counter;
#if MANAGER == PPLL
layout(std430, binding = 1) writeonly buffer Next {
    uint next[];
};
#endif
layout(std430, binding = 0) writeonly buffer Records {
    uvec4 records[];
};

void main() {
    STORE_DEPTH
    SKIP_HIDDEN
    uint at = place(counter);
    counter += 1u;
    if (at < band.capacity) {
        vec4 color = source_color();
        records[at * WORDS] = head_of(source_depth(), source_id(), color);
#if FLOAT_COLOR
        records[at * WORDS + 1u] = floatBitsToUint(color);
#endif
#if MANAGER == PPLL
        // The anchor would say the same as the counter, one more than the newest node.
        next[at] = at;
#endif
    }
}
