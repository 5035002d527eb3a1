// The depth range that a pass of coherent or hybrid layer peeling is clipped to, from maps of the image's size: what
// lies before it has been composited, and it ends at the nearest of three depths. A pass with fewer ends binds one twice.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

layout(binding = 1) uniform sampler2D lower;
layout(binding = 2) uniform sampler2D upper;
layout(binding = 3) uniform sampler2D other_upper;
layout(binding = 4) uniform sampler2D opaque;

float depth_in(sampler2D map) {
    return texelFetch(map, ivec2(gl_FragCoord.xy), 0).r;
}

float lower_bound() {
    return depth_in(lower);
}

float opaque_depth() {
    return depth_in(opaque);
}

float upper_bound() {
    return min(min(depth_in(upper), depth_in(other_upper)), opaque_depth());
}

// For compositing front to back: (ONE_MINUS_DST_ALPHA, ONE).
vec4 premultiplied_color() {
    vec4 straight = surface_color();
    return vec4(straight.rgb * straight.a, straight.a);
}
