// The box around a volume, which is drawn in its place. A box has no colour, and is not shaded. Its id is one of
// a_buffer/id.glsl.

uniform uint volume;    // the number of the volume whose box is drawn; NO_VOLUME for surfaces

const uint NO_VOLUME = 0xFFFFFFFFu;

bool is_box() {
    return volume != NO_VOLUME;
}

uint box_id() {
    return VOLUME | (gl_FrontFacing ? 0u : LEAVES) | volume;
}

// A box is drawn with its depths clamped, not clipped; the clamp comes after the shader.
float box_depth(float depth) {
    return clamp(depth, 0.0, 1.0);
}
