#version 430 core
// Weighted blended transparency (McGuire and Bavoil 2013): a fragment's part of the sums of equation 6. EQUATION is the
// number of the paper's equation for the weight, 7 to 10.
// defines: method

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

layout(location = 0) out vec4 accumulated;    // premultiplied and weighted, added up
layout(location = 1) out vec4 revealage;      // multiplied by 1 - alpha

float square(float x) {
    return x * x;
}

float cube(float x) {
    return x * x * x;
}

// The distance along the view direction.
float distance_to_eye() {
    return 1.0 / gl_FragCoord.w;
}

float weight(float alpha) {
    float z = distance_to_eye();
#if EQUATION == 7
    return alpha * clamp(10.0 / (1e-5 + square(z / 5.0) + square(cube(z / 200.0))), 1e-2, 3e3);
#elif EQUATION == 8
    return alpha * clamp(10.0 / (1e-5 + cube(z / 10.0) + square(cube(z / 200.0))), 1e-2, 3e3);
#elif EQUATION == 9
    return alpha * clamp(0.03 / (1e-5 + square(square(z / 200.0))), 1e-2, 3e3);
#elif EQUATION == 10
    return alpha * max(3e3 * cube(1.0 - gl_FragCoord.z), 1e-2);
#endif
}

void main() {
    STORE_DEPTH
    vec4 straight = surface_color();
    accumulated = vec4(straight.rgb * straight.a, straight.a) * weight(straight.a);
    revealage = vec4(straight.a);
}
