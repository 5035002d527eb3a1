#version 430 core
// The colour of a lit surface, straight alpha. The light stands at the eye; both sides are lit, and which one is seen,
// the colour may tell.

in vec3 world_position;
in vec3 world_normal;
in vec4 vertex_color;

uniform vec3 eye;
uniform bool two_sided;
uniform vec3 inside;

// How much light a surface returns that is seen edge-on; one that faces the eye returns 1.
const float AMBIENT = 0.25;

vec4 surface_color() {
    vec3 color = (two_sided && !gl_FrontFacing) ? inside : vertex_color.rgb;
    float facing = abs(dot(normalize(world_normal), normalize(eye - world_position)));
    return vec4(color * mix(AMBIENT, 1.0, facing), vertex_color.a);
}
