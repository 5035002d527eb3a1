#version 430 core
// A layer over those behind it, back to front: straight alpha, for (SRC_ALPHA, ONE_MINUS_SRC_ALPHA).
// vertex: screen.vert

#include "common/layer.glsl"

out vec4 color;

void main() {
    color = layer();
}
