// The volumes as the shader has them: samples, places, transfer functions. Nothing is left to the filtering of textures,
// whose weights have 8 bits on many drivers.

struct Place {
    vec4 eye;        // in the volume's indices; w: its sampling distance, in world units
    vec4 right;      // from the image's middle to its right border at a distance of 1, in indices; w: the last index of x
    vec4 up;         // likewise to its upper border; w: of y
    vec4 forward;    // the view direction, in indices; w: of z
};

layout(std140, binding = 1) uniform Volumes {
    vec4 frustum;    // near, far; half the image's width and height at a distance of 1
    vec2 size;       // the image's width and height in pixels
    float slice_spacing;    // from slice to slice, where volumes are drawn as slices
    Place places[VOLUMES];
};
layout(binding = 7) uniform sampler3D samples[VOLUMES];
// POINTS of each volume, two texels each: value and density; colour. The points after the last repeat it at infinity.
layout(binding = 6) uniform samplerBuffer transfer;

// Less than every value; in the place of the samples that are empty. A cell with one of them has no value.
#define EMPTY -3e38
bool is_empty(float value) {
    return value < -2e38;
}

// Between the eight samples around an index.
float value_at(sampler3D lattice, vec3 index, vec3 last) {
    index = clamp(index, vec3(0.0), last);
    ivec3 cell = min(ivec3(index), ivec3(last) - 1);
    vec3 part = index - vec3(cell);
    vec4 from = vec4(
        texelFetch(lattice, cell, 0).r,
        texelFetch(lattice, cell + ivec3(0, 1, 0), 0).r,
        texelFetch(lattice, cell + ivec3(0, 0, 1), 0).r,
        texelFetch(lattice, cell + ivec3(0, 1, 1), 0).r
    );
    vec4 to = vec4(
        texelFetch(lattice, cell + ivec3(1, 0, 0), 0).r,
        texelFetch(lattice, cell + ivec3(1, 1, 0), 0).r,
        texelFetch(lattice, cell + ivec3(1, 0, 1), 0).r,
        texelFetch(lattice, cell + ivec3(1, 1, 1), 0).r
    );
    vec4 low = min(from, to);
    if (is_empty(min(min(low.x, low.y), min(low.z, low.w)))) {
        return EMPTY;
    }
    vec4 along_x = from + (to - from) * part.x;
    vec2 along_y = along_x.xz + (along_x.yw - along_x.xz) * part.y;
    return along_y.x + (along_y.y - along_y.x) * part.z;
}

// Colour x density, and density: linear between the two points around a value; nothing of what is empty.
vec4 medium_of(int volume, float value) {
    if (is_empty(value)) {
        return vec4(0.0);
    }
    int first = 2 * POINTS * volume;
    int at = 0;    // the last point that is not above the value
#define H(half) at += texelFetch(transfer, first + 2 * (at + half)).r <= value ? half : 0;
#include "a_buffer/halvings"
    int point = first + 2 * at;
    vec2 from = texelFetch(transfer, point).rg;
    vec2 to = texelFetch(transfer, point + 2).rg;
    float part = clamp((value - from.r) / (to.r - from.r), 0.0, 1.0);
    float density = from.g + (to.g - from.g) * part;
    vec3 low = texelFetch(transfer, point + 1).rgb;
    vec3 color = low + (texelFetch(transfer, point + 3).rgb - low) * part;
    return vec4(color * density, density);
}

// Where the ray towards `toward` (the image's borders are -1 and 1) is at a distance along the view direction, in a
// volume's indices.
vec3 index_at(Place place, vec2 toward, float distance) {
    vec3 direction = place.forward.xyz + place.right.xyz * toward.x + place.up.xyz * toward.y;
    return place.eye.xyz + direction * distance;
}

vec3 last_index(Place place) {
    return vec3(place.right.w, place.up.w, place.forward.w);
}

bool is_inside(Place place, vec2 toward, float distance) {
    vec3 index = index_at(place, toward, distance);
    return all(greaterThanEqual(index, vec3(0.0))) && all(lessThanEqual(index, last_index(place)));
}

// Of volume i, at a place on the ray.
vec4 medium_at(int i, sampler3D lattice, vec2 toward, float distance) {
    Place place = places[i];
    return medium_of(i, value_at(lattice, index_at(place, toward, distance), last_index(place)));
}
