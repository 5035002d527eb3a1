// Depth unit 0 in every way that the invariance experiment tries: what is compared, where, and by which margin.

layout(binding = 0) uniform sampler2DShadow depth_unit_0;
layout(binding = 4) uniform sampler2D depth_unit_0_texels;    // the same texture, without comparison

in vec2 r_and_q;

uniform float depth_test;    // 0 in the first pass, whose depth test is disabled
uniform float quotient;      // r/q is compared; otherwise the rasteriser's window z
uniform float in_shader;     // the comparison is the shader's; otherwise the sampler's
uniform float steps;         // both sides are rounded to so many steps before; 0: they are not
uniform float bias;          // a fragment has to lie behind the stored depth by more than this

float r_over_q() {
    return r_and_q.x / r_and_q.y;
}

bool is_peeled_away() {
    float z = (quotient != 0.0 ? r_over_q() : gl_FragCoord.z) - bias;
    if (in_shader == 0.0) {
        vec2 here = gl_FragCoord.xy / vec2(textureSize(depth_unit_0, 0));
        return texture(depth_unit_0, vec3(here, z)) == 0.0;
    }
    float stored = texelFetch(depth_unit_0_texels, ivec2(gl_FragCoord.xy), 0).r;
    if (steps != 0.0) {
        z = round(z * steps);
        stored = round(stored * steps);
    }
    return depth_test != 0.0 && z <= stored;
}
