#version 430 core
// Dual depth peeling, before the first peel: where the nearest and the farthest fragments are. No colour is needed.

out vec2 depth;

vec4 surface_color();    // linked with every surface

void main() {
    depth = vec2(-gl_FragCoord.z, gl_FragCoord.z);
}
