#version 430 core
// Triangles that are drawn in pieces, a slab at a time: as geometry.vert, and where a fragment lies along the slabs' normal.
// defines: method

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 inside;    // for surface/mixed.frag

uniform mat4 view_projection;

#include "verified/pieces.glsl"

out vec3 world_position;
out vec3 world_normal;
out vec4 vertex_color;
flat out vec4 vertex_inside;
out float along;

invariant gl_Position;

void main() {
    world_position = position;
    world_normal = normal;
    vertex_color = color;
    vertex_inside = inside;
    along = along_normal(position);
    gl_Position = view_projection * vec4(position, 1.0);
}
