// What lies between the fragments of the ray: "volume rendering is performed for the interleaved ray segments. Volume
// occupancy is tracked through a bitmask which is updated every time a fragment of a volume proxy geometry is
// encountered" (Lindholm et al. 2015, section 6.1). The ray's position and its occupancy outlive a subpass of ppDP
// (section 5.2).

#include "common/view_ray.glsl"

layout(binding = 5) uniform sampler2D opaque;

uint occupancy = 0u;                // bit i: the ray is inside of volume i
uint entered = 0u;                  // bit i: the list has a fragment where volume i is entered
uint left_again = 0u;               // bit i: and one where it is left
float ray_distance = frustum.x;     // up to where the ray has been cast, at first the near plane

// Where the ray begins, the list itself says: inside of what it leaves without having entered it.
void look_for_beginning(uint id) {
    if ((id & VOLUME) != 0u) {
        uint bit = 1u << (id & NUMBER);
        entered |= (id & LEAVES) == 0u ? bit : 0u;
        left_again |= (id & LEAVES) != 0u ? bit : 0u;
    }
}

void begin_ray() {
    occupancy = left_again & ~entered;
}

// The smallest sampling distance of the volumes that the ray is inside of.
float sampling_distance() {
    float smallest = 1.0 / 0.0;
#define V(i) if ((occupancy >> i & 1u) != 0u) { smallest = min(smallest, places[i].eye.w); }
#include "a_buffer/each_volume"
#undef V
    return smallest;
}

void composite_media(vec4 media, float thickness) {
    if (media.a > 0.0) {
        float opacity = opacity_of(media.a * thickness);
        ray_color += ray_transparency * opacity / media.a * media.rgb;
        ray_transparency *= 1.0 - opacity;
    }
}

// Casts the ray on to a depth, or to the opaque surface before it. The last step is cut to the segment's end.
void cast_ray(float depth) {
    float end = max(distance_of(min(depth, texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r)), ray_distance);
    if (occupancy != 0u) {
        float thickness = (end - ray_distance) * slant;
        float step_length = sampling_distance();
        float from = 0.0;
        for (uint number = 1u; from < thickness && !ray_ended(); ++number) {
            float to = min(float(number) * step_length, thickness);
            float middle = ray_distance + (from + to) / (2.0 * slant);
            composite_media(media_at(occupancy, middle), to - from);
            from = to;
        }
    }
    ray_distance = end;
}

// At a fragment: up to it, and through it if it is a proxy's.
void meet(float depth, uint id) {
    cast_ray(depth);
    if ((id & VOLUME) != 0u) {
        occupancy ^= 1u << (id & NUMBER);
        composited += 1u;
    }
}
