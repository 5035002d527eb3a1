// Fixed buffers (Lindholm et al. 2015, figure 4): every pixel has room for as many records as the deepest one has
// fragments.
//
// A row's pixels share their buffers, 16 by 16: first everyone's fragment 0, then everyone's fragment 1. Neighbours are
// filled and resolved together, and so read and write whole lines of the cache. What is left of a row is a smaller
// group, so that no byte is added to what the paper counts.

const uint GROUP = 16u;

// From a pixel's record to its next one.
uint fixed_stride() {
    uint group = uint(gl_FragCoord.x) & ~(GROUP - 1u);
    return min(GROUP, band.width - group);
}

uint fixed_first() {
    uint in_group = uint(gl_FragCoord.x) & (GROUP - 1u);
    return (pixel() - in_group) * band.layers + in_group;
}
