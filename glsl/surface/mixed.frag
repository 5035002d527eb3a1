#version 430 core
// The colour of a surface whose vertices say how it is lit, straight alpha: what unlit.frag and lit.frag do, chosen by
// triangle, for meshes of several kinds that are drawn by one call.

in vec3 world_position;
in vec3 world_normal;
in vec4 vertex_color;
flat in vec4 vertex_inside;    // the colour of back faces; 0 without light, 1 with, 2 with a colour for each side

uniform vec3 eye;

#include "surface/light.glsl"

vec4 surface_color() {
    if (vertex_inside.a < 0.5) {
        return vertex_color;
    }
    bool is_inside = vertex_inside.a > 1.5 && !gl_FrontFacing;
    vec3 color = is_inside ? vertex_inside.rgb : vertex_color.rgb;
    return vec4(color * light(), vertex_color.a);
}
