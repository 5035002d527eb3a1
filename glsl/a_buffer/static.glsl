// The static Local Array: the Fragment List is copied, sorted, composited. What the array has no room for is dropped.

void sort_local_array(uint count) {
#if INSERTION
    for (int k = 1; k < int(count); ++k) {
        insert_before(k, key[k], place_of(k));
    }
#else
    // A network compares all elements that any pixel fills, whatever they hold.
#define X(i, j) COMPARE(key[i], place[i], key[j], place[j])
#include "a_buffer/network"
#endif
}

// Resolves the first `count` fragments of the list, of which there are at least so many.
void resolve_statically(uint count) {
#if !INSERTION
    clear_local_array(min(N, DEEPEST));
#endif
    subpasses += 1u;
    records_read += count;
    uint at = list_first();
    for (int k = 0; k < int(count); ++k) {
        uvec4 head = list_head(at);
        put(k, key_of(head, at), at);
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
