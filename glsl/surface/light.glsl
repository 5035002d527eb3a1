// The light that a surface returns to the eye, at which it stands.

// How much a surface returns that is seen edge-on; one that faces the eye returns 1.
const float AMBIENT = 0.25;

float light() {
    float facing = abs(dot(normalize(world_normal), normalize(eye - world_position)));
    return mix(AMBIENT, 1.0, facing);
}
