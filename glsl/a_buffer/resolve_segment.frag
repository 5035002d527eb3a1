#version 430 core
// Resolve Step of a complexity segment (ppAO): the pixels with more fragments than the segment before can take and no
// more than N. The last segment takes all that are left (errata LX05 to LX07).
// vertex: screen.vert

#include "a_buffer/resolve_pixel.glsl"

void main() {
    uint count = list_length();
    uint before = N == FIRST_SEGMENT ? 0u : uint(N) / 2u;
    if (count <= before || (N != LAST_SEGMENT && count > uint(N))) {
        discard;
    }
    resolve_pixel(count);
}
