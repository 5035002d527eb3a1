#version 430 core
// A surface behind the layers peeled so far (Everitt 2001, "Shadow Mapping as Depth Test"): depth unit 0 is a shadow
// map with the camera's own orientation and resolution, and its comparison is the sampler's.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "common/fragment_depth.glsl"

layout(binding = 0) uniform sampler2DShadow depth_unit_0;

out vec4 color;

void main() {
    STORE_DEPTH
    vec2 here = gl_FragCoord.xy / vec2(textureSize(depth_unit_0, 0));
    float passes = texture(depth_unit_0, vec3(here, FRAGMENT_DEPTH));
    if (passes == 0.0) {
        discard;    // Everitt's alpha test
    }
    color = surface_color();
}
