#version 430 core
// A picture as it is.
// vertex: screen.vert

layout(binding = 2) uniform sampler2D picture;

out vec4 color;

void main() {
    color = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
