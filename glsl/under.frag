#version 430 core
// A layer under those before it, front to back: premultiplied, for (ONE_MINUS_DST_ALPHA, ONE).
// vertex: screen.vert

#include "common/layer.glsl"

out vec4 color;

void main() {
    vec4 straight = layer();
    color = vec4(straight.rgb * straight.a, straight.a);
}
