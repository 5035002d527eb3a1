// The Local Array: N elements of private memory. An element is a fragment's key and where its record is.
//
// The key is the depth and then the order of submission: of two keys the smaller one lies in front, and of equal depths
// the one submitted first.
//
// With KEYS_AS_DOUBLES it is a double whose upper half is the depth, moved up to where a double is not denormal, and whose
// lower half tells the order. Mesa's llvmpipe compares and exchanges many of them at a time. Elsewhere it is two words:
// with doubles, NVIDIA's driver (580.159) composites other fragments in ppDP's later subpasses, with words the right ones,
// and most GPUs have few units for doubles. BEFORE is a macro because llvmpipe (Mesa 22.3) sorts wrongly where a function
// is called in the condition of a loop.
//
// With IN_ORDER a pixel's records lie in the order of their submission, so the lower half is the place of the record,
// and the key is the whole element. With atomics they lie as they came; then the lower half is the id.
//
// As printed, ppDP inserts by depth alone, behind what is equal. So the order in which the list is walked decides between
// equal depths. A linked list that was filled in order is walked from its newest record, so its places are counted down.
// defines: method

#define AS_WALKED (AS_PRINTED && PEEL_ALWAYS)

#define DOUBLES KEYS_AS_DOUBLES

#if DOUBLES
#define KEY double
#define BEFORE(a, b) ((a) < (b))

KEY key_with(uint depth, uint order) {
    return packDouble2x32(uvec2(order, depth + 0x00100000u));
}
float depth_of(KEY key_f) {
    return uintBitsToFloat(unpackDouble2x32(key_f).y - 0x00100000u);
}
uint order_of(KEY key_f) {
    return unpackDouble2x32(key_f).x;
}

// No depth lies before 0.
const KEY BEFORE_ALL = 0.0LF;
const KEY BEHIND_ALL = packDouble2x32(uvec2(0u, 0x7F000000u));
#else
#define KEY uvec2    // the depth's bits plus 1, the order
#define BEFORE(a, b) ((a).x < (b).x || ((a).x == (b).x && (a).y < (b).y))

KEY key_with(uint depth, uint order) {
    return uvec2(depth + 1u, order);
}
float depth_of(KEY key_f) {
    return uintBitsToFloat(key_f.x - 1u);
}
uint order_of(KEY key_f) {
    return key_f.y;
}

const KEY BEFORE_ALL = uvec2(0u);
const KEY BEHIND_ALL = uvec2(0xFFFFFFFFu);
#endif

KEY key[N];

#if IN_ORDER
#if AS_WALKED && MANAGER == PPLL
KEY key_of(uvec4 head, uint at, uint walked) {
    return key_with(head.x, ~at);
}
uint place_of(int k) {
    return ~order_of(key[k]);
}
#else
KEY key_of(uvec4 head, uint at, uint walked) {
    return key_with(head.x, at);
}
uint place_of(int k) {
    return order_of(key[k]);
}
#endif
void put(int k, KEY key_f, uint place_f) {
    key[k] = key_f;
}
#else
uint place[N];

KEY key_of(uvec4 head, uint at, uint walked) {
#if AS_WALKED
    return key_with(head.x, walked);
#else
    return key_with(head.x, head.y);
#endif
}
uint place_of(int k) {
    return place[k];
}
void put(int k, KEY key_f, uint place_f) {
    key[k] = key_f;
    place[k] = place_f;
}
#endif

// The fragment in front goes to (or stays in) the first, the other one to the second.
#if IN_ORDER && DOUBLES
#define COMPARE(key_i, place_i, key_j, place_j) { \
    KEY front = min(key_i, key_j); \
    key_j = max(key_i, key_j); \
    key_i = front; \
}
#elif IN_ORDER
#define COMPARE(key_i, place_i, key_j, place_j) { \
    bool swap = BEFORE(key_j, key_i); \
    KEY front = swap ? key_j : key_i; \
    key_j = swap ? key_i : key_j; \
    key_i = front; \
}
#else
#define COMPARE(key_i, place_i, key_j, place_j) { \
    bool swap = BEFORE(key_j, key_i); \
    KEY front = swap ? key_j : key_i; \
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
void insert_before(int hole, KEY key_f, uint place_f) {
    while (hole > 0 && BEFORE(key_f, key[hole - 1])) {
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
