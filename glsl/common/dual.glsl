// The depths between which fragments are left: -nearest and farthest, so that one MAX finds both.

layout(binding = 2) uniform sampler2D depths;

const vec2 NOTHING = vec2(-2.0);    // no fragment is nearer than 0 and none is farther than 1

// Where this pixel's nearest and farthest fragments are; nearest > farthest if none is left.
vec2 nearest_and_farthest() {
    vec2 stored = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).rg;
    return vec2(-stored.r, stored.g);
}
