// The ray through the pixel's centre, and what the volumes have along it. Positions are distances along the view
// direction.

#include "common/volume.glsl"

vec2 toward = 2.0 * gl_FragCoord.xy / size.xy - 1.0;
float slant = length(vec3(toward * frustum.zw, 1.0));    // the ray's length over a distance of 1

#ifdef INVERSE_W
// Of a depth as common/fragment_depth.glsl makes it.
float distance_of(float depth) {
    float part = uintBitsToFloat(floatBitsToUint(1.0) + 0x00800000u - floatBitsToUint(depth));    // near / w
    return min(frustum.x / part, frustum.y);
}
#else
// A difference of two nearly equal products, so doubles.
float distance_of(float depth) {
    double near = double(frustum.x);
    double far = double(frustum.y);
    return float(near * far / (far - double(depth) * (far - near)));
}
#endif

// 1 - exp(-x), which for small x float's exp has no digits for.
float opacity_of(float x) {
    float small = x * (1.0 - x / 2.0 * (1.0 - x / 3.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * (1.0 - x / 6.0)))));
    return x < 0.25 ? small : 1.0 - exp(-x);
}

// All volumes of the bitmask together: colour x density, and density.
vec4 media_at(uint volumes, float distance) {
    vec4 media = vec4(0.0);
#define V(i) if ((volumes >> i & 1u) != 0u) { media += medium_at(i, samples[i], toward, distance); }
#include "a_buffer/each_volume"
#undef V
    return media;
}
