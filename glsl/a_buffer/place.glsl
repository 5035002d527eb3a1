// Where the fragment number `count` of this pixel goes, from 0 in the order in which they come; at or past
// band.capacity if there is no room. One for each memory manager (Lindholm et al. 2015, figure 4).

#if MANAGER == FFB
uint place(uint count) {
    return count < band.layers ? pixel() * band.layers + count : band.capacity;
}
#elif MANAGER == DFB
layout(std430, binding = 2) readonly buffer Offsets {
    uint base_offset[];
};
uint place(uint count) {
    return base_offset[pixel()] + count;
}
#else
layout(std430, binding = 1) writeonly buffer Next {
    uint next[];
};
layout(std430, binding = 3) buffer Pool {
    uint nodes;
};
uint place(uint count) {
    return atomicAdd(nodes, 1u);
}
#endif
