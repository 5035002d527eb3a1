// The Resolve Step of a pixel with `count` fragments, by a Local Array of N elements.
// defines: method

#define INSERTION (SORT_BY_INSERTION || N > LARGEST_NETWORK)

#include "a_buffer/pixel.glsl"
#include "a_buffer/record.glsl"
#include "a_buffer/list.glsl"
#include "a_buffer/ray.glsl"
#if VOLUMES
#include "a_buffer/volume_ray.glsl"
#endif
#include "a_buffer/local_array.glsl"
#if PEEL_ALWAYS
#include "a_buffer/pp_dp.glsl"
#elif PP_DP && N == LAST_SEGMENT
#include "a_buffer/static.glsl"
#include "a_buffer/pp_dp.glsl"
#else
#include "a_buffer/static.glsl"
#endif

void resolve_pixel(uint count) {
    uint fits = min(count, uint(N));
#if PEEL_ALWAYS
    resolve_by_peeling(count);
#elif PP_DP && N == LAST_SEGMENT
    if (count > fits) {
        resolve_by_peeling(count);
    } else {
        resolve_statically(count, fits);
    }
#else
    resolve_statically(count, fits);
#endif
#if VOLUMES
    cast_ray(1.0);
#endif
    finish_ray(uint(N), fits);
}
