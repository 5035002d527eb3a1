// A pixel's place in its band.

#include "a_buffer/band.glsl"

// Row by row from the band's first.
uint pixel() {
    uvec2 here = uvec2(gl_FragCoord.xy);
    return (here.y - band.first_row) * band.width + here.x;
}
