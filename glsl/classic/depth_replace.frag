#version 430 core
// The same with NV_texture_shader's DOT_PRODUCT_DEPTH_REPLACE: where texture shaders are enabled, the depth that is tested
// and stored is not the rasteriser's.
// vertex: classic/vertex.vert

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag: the primary colour

#include "classic/textured.glsl"
#include "classic/alpha_test.glsl"
#include "classic/texture_shader.glsl"

out vec4 color;

void main() {
    vec4 fragment = textured(surface_color());
    if (!alpha_test(fragment.a)) {
        discard;
    }
    color = fragment;
    gl_FragDepth = gl_FragCoord.z;
    if (replaces_depth) {
        float depth = depth_replace();
        // The extension rejects what lies outside of the depth range. What a shader writes, OpenGL clamps.
        if (depth < 0.0 || depth > 1.0) {
            discard;
        }
        gl_FragDepth = depth;
    }
}
