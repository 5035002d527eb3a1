#version 430 core
// A peel of dual depth peeling (Bavoil and Myers 2008). A fragment before the nearest or behind the farthest one left has
// been peeled; one at the nearest goes to the front, one at the farthest to the back, and those in between say where
// the next peel is. Whoever has nothing for a target adds what its blending ignores.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"
#include "common/dual.glsl"

layout(location = 0) out vec2 next;     // blended by MAX
layout(location = 1) out vec4 front;    // premultiplied, under what is there
layout(location = 2) out vec4 back;     // premultiplied, under those of the same depth

void main() {
    STORE_DEPTH
    vec2 bounds = nearest_and_farthest();
    float z = FRAGMENT_DEPTH;
    if (z < bounds.x || z > bounds.y) {
        discard;
    }
    bool at_nearest = z == bounds.x;
    bool at_farthest = z == bounds.y;
    vec4 straight = surface_color();
    vec4 color = vec4(straight.rgb * straight.a, straight.a);
    next = (at_nearest || at_farthest) ? NOTHING : vec2(-z, z);
    front = at_nearest ? color : vec4(0.0);
    back = (at_farthest && !at_nearest) ? color : vec4(0.0);
}
