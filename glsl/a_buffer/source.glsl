// What a fragment comes from, for its record: a surface, or with VOLUMES the box around one (Lindholm et al. 2015, section
// 6.1).
// defines: method

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag
uniform uint first_triangle;

#include "common/fragment_depth.glsl"

// Of marked pixels' lists, VOLUMES are those of slices.
#if VOLUMES && !MARKED
#include "a_buffer/box.glsl"

float source_depth() {
    return box_depth(FRAGMENT_DEPTH);
}

uint source_id() {
    return is_box() ? box_id() : SURFACE | (first_triangle + uint(gl_PrimitiveID));
}

vec4 source_color() {
    return is_box() ? vec4(0.0) : surface_color();
}
#else
float source_depth() {
    return FRAGMENT_DEPTH;
}

uint source_id() {
    return SURFACE | (first_triangle + uint(gl_PrimitiveID));
}

vec4 source_color() {
    return surface_color();
}
#endif

// What an opaque surface hides is in no list. The depth test comes before the shader, and so before its writes; but not
// where the shader itself says what is tested. Where only marked pixels have lists, the stencil test must come before the
// shader, and the depth buffer holds other depths.
#if MARKED
#include "verified/hidden.glsl"
#undef STORE_DEPTH
#define STORE_DEPTH
layout(early_fragment_tests) in;
#define SKIP_HIDDEN SKIP_WHAT_IS_HIDDEN
#elif defined(INVERSE_W)
layout(binding = 5) uniform sampler2D opaque;

bool is_hidden() {
#if VOLUMES
    if (is_box()) {
        return false;
    }
#endif
    return source_depth() >= texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r;
}
#define SKIP_HIDDEN if (is_hidden()) { discard; }
#else
layout(early_fragment_tests) in;
#define SKIP_HIDDEN
#endif
