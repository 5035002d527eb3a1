// The ray so far, front to back, and what it has cost.
// defines: method

layout(location = 0) out vec4 color;
layout(location = 1) out uvec4 cost;

vec3 ray_color = vec3(0.0);
float ray_transparency = 1.0;
uint records_read = 0u;
uint composited = 0u;
uint subpasses = 0u;

bool ray_ended() {
    return ray_transparency < uintBitsToFloat(uint(TERMINATION));
}

void composite(vec4 fragment) {
    ray_color += ray_transparency * fragment.a * fragment.rgb;
    ray_transparency *= 1.0 - fragment.a;
    composited += 1u;
}

// Premultiplied, for (ONE, ONE_MINUS_SRC_ALPHA); and the pixel's part in the counters: records read, fragments
// composited, subpasses, and of the Local Array the elements reserved and used.
void finish_ray(uint reserved, uint used) {
    color = vec4(ray_color, 1.0 - ray_transparency);
    cost = uvec4(records_read, composited, subpasses, reserved << 16 | used);
}
