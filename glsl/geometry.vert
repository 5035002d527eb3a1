#version 430 core
// Every surface, in every pass. The position is invariant: passes that compare depths for equality, or that peel away
// what an earlier pass has drawn, need the same depth from every program.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 inside;    // for surface/mixed.frag

uniform mat4 view_projection;

out vec3 world_position;
out vec3 world_normal;
out vec4 vertex_color;
flat out vec4 vertex_inside;

invariant gl_Position;

void main() {
    world_position = position;
    world_normal = normal;
    vertex_color = color;
    vertex_inside = inside;
    gl_Position = view_projection * vec4(position, 1.0);
}
