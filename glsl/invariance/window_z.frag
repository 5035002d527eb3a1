#version 430 core
// A surface behind the layers peeled so far; the depth that is stored is the rasteriser's window z.
// vertex: invariance/vertex.vert

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

#include "invariance/compare.glsl"

out vec4 color;

void main() {
    if (is_peeled_away()) {
        discard;
    }
    color = surface_color();
}
