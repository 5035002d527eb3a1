#version 430 core
// Every fragment at a peeled depth, premultiplied, for (ONE_MINUS_DST_ALPHA, ONE): those of equal depth go under one
// another in the order in which they come. Depth unit 0 holds the opaque depth: a pixel that has been finished has it in
// depth unit 1 too, and what lies exactly on an opaque surface is hidden by it.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

layout(binding = 0) uniform sampler2DShadow depth_unit_0;

out vec4 color;

void main() {
    STORE_DEPTH
    vec2 here = gl_FragCoord.xy / vec2(textureSize(depth_unit_0, 0));
    if (texture(depth_unit_0, vec3(here, FRAGMENT_DEPTH)) == 0.0) {
        discard;
    }
    vec4 straight = surface_color();
    color = vec4(straight.rgb * straight.a, straight.a);
}
