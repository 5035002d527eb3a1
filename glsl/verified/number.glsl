// The number of a marked pixel's list: how many marked pixels come before it, row by row from the bottom.
// a_buffer/band.glsl comes before it.

layout(binding = 2) uniform usamplerBuffer numbers;    // the marks of 32 pixels of a row, and how many come before them

uint list_number() {
    uvec2 here = uvec2(gl_FragCoord.xy);
    uint across = (band.width + 31u) / 32u;
    uvec2 word = texelFetch(numbers, int(here.y * across + here.x / 32u)).rg;
    return word.g + uint(bitCount(word.r & ((1u << (here.x % 32u)) - 1u)));
}
