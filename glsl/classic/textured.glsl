// What texturing makes of the primary colour: by the units' environments, or by the alpha portion of NV_register_combiners'
// first general combiner, whose colour goes through as it is.

#include "classic/textures.glsl"
#include "classic/texture_environment.glsl"

const int REGISTER_ZERO = 0;
const int PRIMARY_COLOR = 1;
const int TEXTURE0 = 2;

uniform bool register_combiners;
uniform ivec3 combiner[2];    // A and B: register, mapping (1 inverts), component (0 is blue, 1 alpha)

vec4 texture_register(int unit) {
    vec4 value = texel(unit);
    switch (base_format[unit]) {
        case LUMINANCE: return vec4(value.rrr, 1.0);
        case INTENSITY: return value.rrrr;
        case ALPHA: return vec4(0.0, 0.0, 0.0, value.r);
    }
    return value;
}

float combiner_input(int variable, vec4 primary) {
    int from = combiner[variable].x;
    vec4 value = from == PRIMARY_COLOR ? primary
        : from >= TEXTURE0 ? texture_register(from - TEXTURE0)
        : vec4(0.0);
    float part = clamp(combiner[variable].z == 0 ? value.b : value.a, 0.0, 1.0);
    return combiner[variable].y == 1 ? 1.0 - part : part;
}

vec4 textured(vec4 primary) {
    if (register_combiners) {
        return vec4(primary.rgb, combiner_input(0, primary) * combiner_input(1, primary));
    }
    vec4 fragment = primary;
    for (int unit = 0; unit < 4; ++unit) {
        fragment = texture_environment(unit, fragment, texel(unit));
    }
    return fragment;
}
