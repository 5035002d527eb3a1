#version 430 core
// Clear Step where a pixel's records lie behind its base offset: the counter begins there, and so it always says where
// the next record goes. Fill Steps then look up no offset, of which there would be one for every fragment.
// vertex: screen.vert

#include "a_buffer/pixel.glsl"
#include "a_buffer/offset.glsl"

layout(location = 0) out uint counter;

void main() {
    counter = base_offset();
}
