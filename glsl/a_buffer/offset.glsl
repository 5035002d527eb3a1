// DFB's base offsets (Lindholm et al. 2015, figure 4), by a prefix scan of the image's pixels.

layout(std430, binding = 2) readonly buffer Offsets {
    uint offsets[];
};

// Where this pixel's records begin among the band's.
uint base_offset() {
    return offsets[band.first_row * band.width + pixel()] - band.before;
}
