// Texture units of the fixed functions: which texture each looks up, by projective coordinates, and what its texels
// become. A unit's four kinds of texture have samplers of their own, since GLSL gives a sampler one type.

layout(binding = 16) uniform sampler2D texture_2d[4];
layout(binding = 20) uniform sampler2DShadow shadow_2d[4];
layout(binding = 24) uniform sampler2DRect rectangle[4];
layout(binding = 28) uniform sampler2DRectShadow shadow_rectangle[4];

const int NO_TEXTURE = 0;
const int TEXTURE_2D = 1;
const int SHADOW_2D = 2;
const int RECTANGLE = 3;
const int SHADOW_RECTANGLE = 4;

uniform int target[4];

// GL_DEPTH_TEXTURE_MODE, or a texture with colours of its own.
const int LUMINANCE = 0;
const int INTENSITY = 1;
const int ALPHA = 2;
const int RGBA = 3;

uniform int base_format[4];

in vec4 tex_coord[4];

// With ARB_shadow's compare mode the result of r/q against the texel, 0 or 1, stands in the texel's place.
vec4 texel(int unit) {
    vec4 at = tex_coord[unit];
    switch (target[unit]) {
        case TEXTURE_2D: return textureProj(texture_2d[unit], at);
        case SHADOW_2D: return vec4(textureProj(shadow_2d[unit], at));
        case RECTANGLE: return textureProj(rectangle[unit], at);
        case SHADOW_RECTANGLE: return vec4(textureProj(shadow_rectangle[unit], at));
    }
    return vec4(0.0);
}
