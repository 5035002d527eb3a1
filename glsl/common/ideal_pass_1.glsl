// Algorithm 2, lines 14 to 30. Returns whether the fragment lies in the range.

bool peel_fragment(float z) {
    if (!(peel.r < z && z < depths.y)) {
        return false;
    }
    if (z < depths.x) {
        depths = vec4(z, depths.x, z, 0.0);
    } else if (depths.w != 0.0) {
        depths.z = min(depths.z, z);
    } else {
        depths.w = z < depths.z ? 1.0 : 0.0;
        depths.z = z;
    }
    return true;
}
