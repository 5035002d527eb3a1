// The number of a marked pixel's list.

layout(binding = 2) uniform usampler2D anchor;

uint list_number() {
    return texelFetch(anchor, ivec2(gl_FragCoord.xy), 0).r;
}
