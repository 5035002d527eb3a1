#version 430 core
// geometry.vert, with what the shadow lookup of 2001 compares: r and q, interpolated in clip space (Everitt 2001, "An
// Invariance Issue"). They are homogeneous window coordinates: depth range scale and bias come before the division.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;

uniform mat4 view_projection;

out vec3 world_position;
out vec3 world_normal;
out vec4 vertex_color;
out vec2 r_and_q;

invariant gl_Position;

void main() {
    world_position = position;
    world_normal = normal;
    vertex_color = color;
    gl_Position = view_projection * vec4(position, 1.0);
    r_and_q = vec2(0.5 * gl_Position.z + 0.5 * gl_Position.w, gl_Position.w);
}
