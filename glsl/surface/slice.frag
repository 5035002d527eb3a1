#version 430 core
// The colour of a slice through the volumes, straight alpha. Its opacity is that of the slab that it stands in the middle
// of, on this pixel's ray: the distance from slice to slice, and longer the more the ray slants.

#include "common/fragment_depth.glsl"
#include "common/view_ray.glsl"

// Bit i: the place at this distance is inside of volume i.
uint volumes_around(float distance) {
    uint volumes = 0u;
#define V(i) volumes |= is_inside(places[i], toward, distance) ? 1u << i : 0u;
#include "a_buffer/each_volume"
#undef V
    return volumes;
}

vec4 surface_color() {
    float distance = distance_of(FRAGMENT_DEPTH);
    vec4 media = media_at(volumes_around(distance), distance);
    float opacity = opacity_of(media.a * slice_spacing * slant);
    return media.a > 0.0 ? vec4(media.rgb / media.a, opacity) : vec4(0.0);
}
