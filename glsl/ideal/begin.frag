#version 450 core
#extension GL_EXT_shader_framebuffer_fetch : require
// Algorithm 2, lines 7 to 12: z3 goes to the opaque depth, so that a pixel with nothing left ends there.

#include "common/ideal.glsl"

void main() {
    peel = vec4(depths.z);
    depths = vec4(vec3(opaque_depth()), 0.0);
}
