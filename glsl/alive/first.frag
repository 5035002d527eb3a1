#version 430 core
// The nearest layer, before which every pixel is alive.
// vertex: screen.vert

#include "common/alive.glsl"

void main() {
    under();
}
