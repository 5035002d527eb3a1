#version 430 core
// What lies at the upper bound, unless that is the opaque depth.

#include "common/clip.glsl"

out vec4 color;

void main() {
    float z = gl_FragCoord.z;
    if (!(z == upper_bound() && z < opaque_depth())) {
        discard;
    }
    color = premultiplied_color();
}
