// The Local Array: N elements of private memory. An element is a fragment's key and where its record is.
//
// The key is a double whose upper half is the depth, moved up to where a double is not denormal, and whose lower half
// tells the order of submission: of two such doubles the smaller one lies in front, and of equal depths the one submitted
// first. No depth lies before 0, so 0.0 is smaller than every key.
//
// With IN_ORDER a pixel's records lie in the order of their submission, so the lower half is the place of the record,
// and the key is the whole element. With atomics they lie as they came; then the lower half is the id.
// defines: method

double key[N];

double key_with(uint depth, uint order) {
    return packDouble2x32(uvec2(order, depth + 0x00100000u));
}

float depth_of(double key) {
    return uintBitsToFloat(unpackDouble2x32(key).y - 0x00100000u);
}

const double BEHIND_ALL = packDouble2x32(uvec2(0u, 0x7F000000u));

#if IN_ORDER
double key_of(uvec4 head, uint at) {
    return key_with(head.x, at);
}
uint place_of(int k) {
    return unpackDouble2x32(key[k]).x;
}
void put(int k, double key_f, uint place_f) {
    key[k] = key_f;
}
// The fragment in front goes to (or stays in) the first, the other one to the second.
#define COMPARE(key_i, place_i, key_j, place_j) { \
    double front = min(key_i, key_j); \
    key_j = max(key_i, key_j); \
    key_i = front; \
}
#else
uint place[N];

double key_of(uvec4 head, uint at) {
    return key_with(head.x, head.y);
}
uint place_of(int k) {
    return place[k];
}
void put(int k, double key_f, uint place_f) {
    key[k] = key_f;
    place[k] = place_f;
}
#define COMPARE(key_i, place_i, key_j, place_j) { \
    bool swap = key_j < key_i; \
    double front = swap ? key_j : key_i; \
    key_j = swap ? key_i : key_j; \
    key_i = front; \
    uint place_front = swap ? place_j : place_i; \
    place_j = swap ? place_i : place_j; \
    place_i = place_front; \
}
#endif

void clear_local_array(int count) {
    for (int k = 0; k < count; ++k) {
        put(k, BEHIND_ALL, 0u);
    }
}

// Moves elements behind `key_f` one place on, beginning with the one before `hole`, and puts it where it belongs.
void insert_before(int hole, double key_f, uint place_f) {
    while (hole > 0 && key_f < key[hole - 1]) {
        put(hole, key[hole - 1], place_of(hole - 1));
        --hole;
    }
    put(hole, key_f, place_f);
}

// Composites the first `count` elements, front to back, until the ray ends.
void resolve_local_array(uint count) {
    for (int k = 0; k < int(count) && !ray_ended(); ++k) {
        uint at = place_of(k);
        uvec4 head = list_head(at);
#if VOLUMES
        meet(depth_of(key[k]), head.y);
        if ((head.y & VOLUME) != 0u) {
            continue;
        }
#endif
        composite(list_color(at, head));
    }
}
