// Where the fragment number `count` of this pixel goes, from 0 in the order in which they come; at or past
// band.capacity if there is no room (Lindholm et al. 2015, figure 4).
//
// Fixed buffers: into the pixel's own layers. Dynamic buffers: behind the pixel's base offset. Linked lists too, if no
// atomic may take their nodes from the pool: fragments of different pixels have no order and can share no counter, so a
// node's place follows from the pixel and its own count, and a scan of all counts is what leaves no gaps. A pixel's nodes
// then lie side by side, and its links say what the offsets say.

#if MANAGER == FFB
#include "a_buffer/fixed.glsl"
uint place(uint count) {
    return count < band.layers ? fixed_first() + count * fixed_stride() : band.capacity;
}
#else
layout(std430, binding = 2) readonly buffer Offsets {
    uint base_offset[];
};
uint place(uint count) {
    return base_offset[pixel()] + count;
}
#endif
