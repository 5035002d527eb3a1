// Algorithm 2's 'Composite fragment into color buffer', front to back.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

void composite_fragment() {
    vec4 straight = surface_color();
    vec4 fragment = vec4(straight.rgb * straight.a, straight.a);
    image = image + fragment * (1.0 - image.a);
}
