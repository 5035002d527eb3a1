// What a fragment comes from, for its record: a surface, or with VOLUMES the box around one (Lindholm et al. 2015, section
// 6.1). A box has no colour, and is not shaded.

vec4 surface_color();    // surface/unlit.frag or surface/lit.frag
uniform uint first_triangle;

#if VOLUMES
uniform uint volume;    // the number of the volume whose box is drawn; NO_VOLUME for surfaces

const uint NO_VOLUME = 0xFFFFFFFFu;

// A box is drawn with its depths clamped, not clipped; the clamp comes after the shader.
float source_depth() {
    return clamp(gl_FragCoord.z, 0.0, 1.0);
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
    return gl_FragCoord.z;
}

uint source_id() {
    return SURFACE | (first_triangle + uint(gl_PrimitiveID));
}

vec4 source_color() {
    return surface_color();
}
#endif
