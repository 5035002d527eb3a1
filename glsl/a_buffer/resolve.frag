#version 430 core
// Resolve Step: every pixel that has a fragment. Which pixels are drawn at all, the stencil test may say.
// vertex: screen.vert

#include "a_buffer/resolve_pixel.glsl"

void main() {
    uint count = list_length();
    if (count == 0u) {
        discard;
    }
    resolve_pixel(count);
}
