#version 430 core
// A surface as it is: opaque geometry, and the methods that blend.

vec4 surface_color();    // surface/unlit.frag, lit.frag or slice.frag

out vec4 color;

void main() {
    color = surface_color();
}
