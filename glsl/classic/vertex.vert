#version 430 core
// geometry.vert, with the texture coordinates of the fixed functions: EYE_LINEAR from planes that the inverse of the
// modelview matrix of their time has been multiplied into, or (0, 0, 0, 1) where none are generated; then each unit's
// texture matrix. The position is invariant: it is that of geometry.vert.
// looks at: classic state

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;

uniform mat4 view_projection;
uniform mat4 modelview;
uniform bool texgen[4];
uniform vec4 eye_planes[16];    // four units, s, t, r and q each
uniform mat4 texture_matrix[4];

out vec3 world_position;
out vec3 world_normal;
out vec4 vertex_color;
out vec4 tex_coord[4];

invariant gl_Position;

vec4 eye_linear(int unit, vec4 eye) {
    return vec4(dot(eye_planes[4 * unit], eye), dot(eye_planes[4 * unit + 1], eye),
                dot(eye_planes[4 * unit + 2], eye), dot(eye_planes[4 * unit + 3], eye));
}

void main() {
    world_position = position;
    world_normal = normal;
    vertex_color = color;
    vec4 eye = modelview * vec4(position, 1.0);
    for (int unit = 0; unit < 4; ++unit) {
        vec4 generated = texgen[unit] ? eye_linear(unit, eye) : vec4(0.0, 0.0, 0.0, 1.0);
        tex_coord[unit] = texture_matrix[unit] * generated;
    }
    gl_Position = view_projection * vec4(position, 1.0);
}
