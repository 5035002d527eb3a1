#version 430 core
// Every fragment, into a list of which only the order of submission matters: the list itself is unordered.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"
#include "a_buffer/id.glsl"
#include "a_buffer/box.glsl"

layout(early_fragment_tests) in;
uniform uint first_triangle;

struct Captured {
    uint x;
    uint y;
    float depth;
    uint source;    // the triangle of a surface, or the id of a box's face
    vec4 color;     // a box has none; red is the number of its triangle, for boxes are drawn in the order of those
};

layout(std430, binding = 0) buffer Count {
    uint count;
};
layout(std430, binding = 1) writeonly buffer List {
    Captured list[];
};

void main() {
    uint place = atomicAdd(count, 1u);
    if (place < list.length()) {
        uvec2 here = uvec2(gl_FragCoord.xy);
        list[place] = is_box()
            ? Captured(here.x, here.y, box_depth(FRAGMENT_DEPTH), box_id(), vec4(gl_PrimitiveID, 0.0, 0.0, 0.0))
            : Captured(here.x, here.y, FRAGMENT_DEPTH, first_triangle + uint(gl_PrimitiveID), surface_color());
    }
}
