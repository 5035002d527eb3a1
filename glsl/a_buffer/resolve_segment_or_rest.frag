#version 430 core
// The same, but that the last segment takes all that are left, too (erratum LX05).
// vertex: screen.vert

#include "a_buffer/resolve_pixel.glsl"
#include "a_buffer/segment.glsl"

void main() {
    uint count = list_length();
    bool rest = N == LAST_SEGMENT && count > uint(N);
    if (!in_segment(count) && !rest) {
        discard;
    }
    resolve_pixel(count);
}
