// The static Local Array: the Fragment List is copied, sorted, composited. What the array has no room for is dropped.

// A comparator: the element in front comes first.
#define X(i, j) { \
    bool swap = key[j] < key[i]; \
    double front = swap ? key[j] : key[i]; \
    key[j] = swap ? key[i] : key[j]; \
    key[i] = front; \
    uint place = swap ? place_of[j] : place_of[i]; \
    place_of[j] = swap ? place_of[i] : place_of[j]; \
    place_of[i] = place; \
}

void sort_local_array(uint count) {
#if INSERTION
    for (int k = 1; k < int(count); ++k) {
        double key_k = key[k];
        uint place_k = place_of[k];
        int hole = k;
        while (hole > 0 && key_k < key[hole - 1]) {
            key[hole] = key[hole - 1];
            place_of[hole] = place_of[hole - 1];
            --hole;
        }
        key[hole] = key_k;
        place_of[hole] = place_k;
    }
#else
#include "a_buffer/network"
#endif
}

// Resolves the first `count` fragments of the list, of which there are at least so many.
void resolve_statically(uint count) {
    clear_local_array();
    subpasses += 1u;
    records_read += count;
    uint at = list_first();
    for (int k = 0; k < int(count); ++k) {
        uvec4 head = list_head(at);
        key[k] = key_of(head);
        place_of[k] = at;
        at = list_next(at);
#if VOLUMES
        look_for_beginning(head.y);
#endif
    }
#if VOLUMES
    begin_ray();
#endif
    sort_local_array(count);
    resolve_local_array(count);
}
