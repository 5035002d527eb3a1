#version 430 core
// Marks every pixel that failed the proof: a bit for each, in words of 32 pixels of a row.
// vertex: screen.vert
// defines: method

layout(early_fragment_tests) in;

layout(std430, binding = 0) buffer Marks {
    uint marks[];    // row by row from the bottom
};

void main() {
    uvec2 here = uvec2(gl_FragCoord.xy);
    atomicOr(marks[here.y * uint(WORDS_ACROSS) + here.x / 32u], 1u << (here.x % 32u));
}
