#version 430 core
// A later layer. It lies behind another one, so its depth is more than 0, which is that of a pixel that is not alive.
// vertex: screen.vert

#include "common/alive.glsl"

void main() {
    if (texelFetch(layer_depth, ivec2(gl_FragCoord.xy), 0).r == 0.0) {
        discard;
    }
    under();
}
