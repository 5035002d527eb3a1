#version 450 core
#extension GL_EXT_shader_framebuffer_fetch : require
// Algorithm 2's gChanged: pass 1 has found something at this pixel.

#include "common/ideal.glsl"

void main() {
    if (depths.x >= opaque_depth()) {
        discard;
    }
}
