#version 430 core
// Gives every pixel that failed the proof a list of its own, by number, and marks the tile that it is in.
// vertex: screen.vert
// defines: method

layout(early_fragment_tests) in;

layout(std430, binding = 0) buffer Marks {
    uint lists;      // how many pixels have one
    uint tiles[];    // row by row from the bottom: whether there is one
};
layout(location = 0) out uint number;

void main() {
    uvec2 tile = uvec2(gl_FragCoord.xy) / uint(TILE);
    tiles[tile.y * uint(TILES_ACROSS) + tile.x] = 1u;
    number = atomicAdd(lists, 1u);
}
