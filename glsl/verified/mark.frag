#version 430 core
// Gives every pixel that failed the proof a list of its own, by number, and marks the tile that it is in. Where there are
// opaque surfaces, what lies behind the transparent ones goes where the list will be resolved.
// vertex: screen.vert
// defines: method

#include "a_buffer/band.glsl"
#include "verified/list.glsl"

layout(early_fragment_tests) in;

#if OPAQUE
layout(binding = 3) uniform sampler2D behind;
layout(binding = 0, rgba32f) writeonly uniform image2D resolved;
#endif
layout(std430, binding = 0) buffer Marks {
    uint lists;      // how many pixels have one
    uint tiles[];    // row by row from the bottom: whether there is one
};
layout(location = 0) out uint number;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    uvec2 tile = uvec2(here) / uint(TILE);
    tiles[tile.y * uint(TILES_ACROSS) + tile.x] = 1u;
    number = atomicAdd(lists, 1u);
#if OPAQUE
    imageStore(resolved, place_of_list(number), texelFetch(behind, here, 0));
#endif
}
