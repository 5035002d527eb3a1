#version 450 core
#extension GL_EXT_shader_framebuffer_fetch : require
// Algorithm 2, lines 36 to 40.

#include "common/ideal.glsl"
#include "common/ideal_surface.glsl"

void main() {
    float z = gl_FragCoord.z;
    if (peel.r < z && z < depths.z) {
        composite_fragment();
    }
}
