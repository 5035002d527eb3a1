// The static Local Array: the Fragment List is copied, sorted, composited. What the array has no room for is dropped:
// what lies past N in the list ("all fragments beyond this number are discarded", Lindholm et al. 2015, section 4), or
// with KEEP_NEAREST what lies behind the N nearest. ppAO's smaller segments and ppDP drop nothing.
// defines: method

#define KEEPS (KEEP_NEAREST && N == LAST_SEGMENT)

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

#if KEEPS
// The array is full: the farthest of its elements and of this one is dropped.
void keep_if_nearer(KEY key_f, uint place_f) {
#if SORT_BY_INSERTION
    if (BEFORE(key_f, key[N - 1])) {
        insert_before(N - 1, key_f, place_f);
    }
#else
    // The same with constant indices, in an array that is not sorted yet: what is farther goes on to the next element.
#define P(k) COMPARE(key[k], place[k], key_f, place_f)
#include "a_buffer/elements"
#undef P
#endif
}
#endif

// Resolves a list of `count` fragments, of which the array has room for `fits`.
void resolve_statically(uint count, uint fits) {
#if !INSERTION
    clear_local_array(min(N, DEEPEST));
#endif
    subpasses += 1u;
    uint at = list_first();
    for (int k = 0; k < int(fits); ++k) {
        uvec4 head = list_head(at);
        put(k, key_of(head, at, uint(k)), at);
        at = list_next(at);
#if VOLUMES
        look_for_beginning(head.y);
#endif
    }
#if KEEPS
    records_read += count;
#if SORT_BY_INSERTION
    sort_local_array(fits);
#endif
    for (uint f = fits; f < count; ++f) {
        uvec4 head = list_head(at);
        keep_if_nearer(key_of(head, at, f), at);
        at = list_next(at);
#if VOLUMES
        look_for_beginning(head.y);
#endif
    }
#else
    records_read += fits;
#endif
#if VOLUMES
    begin_ray();
#endif
#if !(KEEPS && SORT_BY_INSERTION)
    sort_local_array(fits);
#endif
    resolve_local_array(fits);
}
