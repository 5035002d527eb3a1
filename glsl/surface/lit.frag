#version 430 core
// The colour of a lit surface, straight alpha. The light stands at the eye; both sides are lit, and which one is seen,
// the colour may tell.

in vec3 world_position;
in vec3 world_normal;
in vec4 vertex_color;

uniform vec3 eye;
uniform bool two_sided;
uniform vec3 inside;

#include "surface/light.glsl"

vec4 surface_color() {
    vec3 color = (two_sided && !gl_FrontFacing) ? inside : vertex_color.rgb;
    return vec4(color * light(), vertex_color.a);
}
