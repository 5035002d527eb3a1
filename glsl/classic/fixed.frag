#version 430 core
// The fixed functions of 2001 after the rasteriser: texture environment, alpha test.
// vertex: classic/vertex.vert

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag: the primary colour

#include "classic/textured.glsl"
#include "classic/alpha_test.glsl"

out vec4 color;

void main() {
    vec4 fragment = textured(surface_color());
    if (!alpha_test(fragment.a)) {
        discard;
    }
    color = fragment;
}
