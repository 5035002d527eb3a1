// Where the fragment goes that finds `count` in the pixel's counter; at or past band.capacity if there is no room
// (Lindholm et al. 2015, figure 4).
//
// Fixed buffers: into the pixel's own layers, of which the counter counts those that are taken. Dynamic buffers: where
// the counter says, for it begins at the pixel's base offset (begin.frag). Linked lists too, if no atomic may take their
// nodes from the pool: fragments of different pixels have no order and can share no counter, so a node's place follows
// from the pixel and its own count, and a scan of all counts is what leaves no gaps. A pixel's nodes then lie side by
// side, and its links say what the offsets say.
// defines: method

#if MANAGER == FFB
#include "a_buffer/fixed.glsl"
uint place(uint count) {
    return count < band.layers ? fixed_first() + count * fixed_stride() : band.capacity;
}
#else
uint place(uint count) {
    return count;
}
#endif
