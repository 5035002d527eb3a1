// What a fragment comes from, for its record: a surface, or with VOLUMES the box around one (Lindholm et al. 2015, section
// 6.1). A box has no colour, and is not shaded.
// defines: method

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag
uniform uint first_triangle;

#include "common/fragment_depth.glsl"

// Of marked pixels' lists, VOLUMES are those of slices.
#if VOLUMES && !MARKED
uniform uint volume;    // the number of the volume whose box is drawn; NO_VOLUME for surfaces

const uint NO_VOLUME = 0xFFFFFFFFu;

// A box is drawn with its depths clamped, not clipped; the clamp comes after the shader.
float source_depth() {
    return clamp(FRAGMENT_DEPTH, 0.0, 1.0);
}

uint source_id() {
    if (volume != NO_VOLUME) {
        return VOLUME | (gl_FrontFacing ? 0u : LEAVES) | volume;
    }
    return SURFACE | (first_triangle + uint(gl_PrimitiveID));
}

vec4 source_color() {
    return volume != NO_VOLUME ? vec4(0.0) : surface_color();
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
    if (volume != NO_VOLUME) {
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
