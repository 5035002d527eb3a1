#version 430 core
// Resolve Step of a complexity segment (ppAO), by the pixels' own counts (errata LX06 and LX07).
// vertex: screen.vert

#include "a_buffer/resolve_pixel.glsl"
#include "a_buffer/segment.glsl"

void main() {
    uint count = list_length();
    if (!in_segment(count)) {
        discard;
    }
    resolve_pixel(count);
}
