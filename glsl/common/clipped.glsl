// The main function of a pass that draws what its depth range takes in: a file that includes this defines what that is,
// INSIDE(z). What is drawn is the surface's colour, unless the file defines another, COLOR(z).

#include "common/clip.glsl"

#ifndef COLOR
#define COLOR(z) premultiplied_color()
#endif

out vec4 color;

void main() {
    STORE_DEPTH
    float z = FRAGMENT_DEPTH;
    if (!(INSIDE(z))) {
        discard;
    }
    color = COLOR(z);
}
