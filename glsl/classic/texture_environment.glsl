// GL_TEXTURE_ENV_MODE, by base format, as the tables of OpenGL 1.5 have it (section 3.8.13). A unit whose mode is NONE
// (NV_texture_shader) changes nothing.

const int ENV_NONE = 0;
const int REPLACE = 1;
const int MODULATE = 2;

uniform int env_mode[4];

vec4 texture_environment(int unit, vec4 fragment, vec4 texel) {
    if (target[unit] == NO_TEXTURE || env_mode[unit] == ENV_NONE) {
        return fragment;
    }
    float depth = texel.r;
    bool replace = env_mode[unit] == REPLACE;
    switch (base_format[unit]) {
        case LUMINANCE: return vec4(replace ? vec3(depth) : fragment.rgb * depth, fragment.a);
        case INTENSITY: return replace ? vec4(depth) : fragment * depth;
        case ALPHA: return vec4(fragment.rgb, replace ? depth : fragment.a * depth);
    }
    return replace ? texel : fragment * texel;
}
