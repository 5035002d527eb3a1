#version 430 core
// The fixed functions of 2001 after the rasteriser: texture environment, alpha test.
// vertex: classic/vertex.vert

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag: the primary colour

#include "classic/textures.glsl"
#include "classic/texture_environment.glsl"
#include "classic/alpha_test.glsl"

out vec4 color;

void main() {
    vec4 fragment = surface_color();
    for (int unit = 0; unit < 4; ++unit) {
        fragment = texture_environment(unit, fragment, texel(unit));
    }
    if (!alpha_test(fragment.a)) {
        discard;
    }
    color = fragment;
}
