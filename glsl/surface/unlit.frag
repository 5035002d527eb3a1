#version 430 core
// The colour of a surface as it is, straight alpha. A file of its own, so that what lighting needs is not interpolated
// where there is none: with small triangles that is a large part of the cost.

in vec4 vertex_color;

vec4 surface_color() {
    return vertex_color;
}
