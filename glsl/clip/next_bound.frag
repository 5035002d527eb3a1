#version 430 core
// The upper bound becomes a depth: the next iteration's lower bound.
// vertex: screen.vert

layout(binding = 2) uniform sampler2D upper;
layout(binding = 3) uniform sampler2D other_upper;
layout(binding = 4) uniform sampler2D opaque;

float depth_in(sampler2D map) {
    return texelFetch(map, ivec2(gl_FragCoord.xy), 0).r;
}

void main() {
    gl_FragDepth = min(min(depth_in(upper), depth_in(other_upper)), depth_in(opaque));
}
