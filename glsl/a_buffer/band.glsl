// The band of the image that is rendered.

layout(std140, binding = 0) uniform Band {
    uint first_row;    // of the band, from the bottom
    uint rows;         // of the band
    uint width;        // of the image
    uint layers;       // FFB: how many records each pixel has room for
    uint capacity;     // how many records there is room for in all
    uint before;       // how many fragments the image has before the band
} band;
