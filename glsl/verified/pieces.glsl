// What the pieces of triangles keep: first the slabs' normal, with where along it the positions' origin lies, then from where
// and up to where each piece reaches.

layout(binding = 1) uniform samplerBuffer pieces;

float along_normal(vec3 position) {
    vec4 slabs = texelFetch(pieces, 0);
    return dot(slabs.xyz, position) - slabs.w;
}

bool is_in_piece(uint number, float along) {
    vec2 bounds = texelFetch(pieces, int(number) + 1).xy;
    return bounds.x <= along && along < bounds.y;
}
