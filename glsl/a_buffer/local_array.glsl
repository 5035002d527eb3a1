// The Local Array: N elements of private memory. An element is a fragment's key, which is its depth and then its id, and
// where its record is.
//
// The key is a double whose upper half is the depth, moved up to where a double is not denormal, and whose lower half is
// the id: of two such doubles the smaller one lies in front, and of equal depths the one submitted first. No depth lies
// before 0, so 0.0 is smaller than every key.

double key[N];
uint place_of[N];

double key_of(uvec4 head) {
    return packDouble2x32(uvec2(head.y, head.x + 0x00100000u));
}

float depth_of(double key) {
    return uintBitsToFloat(unpackDouble2x32(key).y - 0x00100000u);
}

const double BEHIND_ALL = packDouble2x32(uvec2(0u, 0x7F000000u));

void clear_local_array() {
    for (int k = 0; k < N; ++k) {
        key[k] = BEHIND_ALL;
        place_of[k] = 0u;
    }
}

// Composites the first `count` elements, front to back, until the ray ends.
void resolve_local_array(uint count) {
    for (int k = 0; k < int(count) && !ray_ended(); ++k) {
        uvec4 head = list_head(place_of[k]);
#if VOLUMES
        meet(depth_of(key[k]), head.y);
        if ((head.y & VOLUME) != 0u) {
            continue;
        }
#endif
        composite(list_color(place_of[k], head));
    }
}
