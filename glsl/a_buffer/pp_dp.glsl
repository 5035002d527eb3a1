// per-pixel Depth Peeling (Lindholm et al. 2015, section 5.2): the Local Array takes the N nearest fragments that have
// not been resolved yet, again and again.
//
// As printed, "not yet resolved" is told by depth alone, so that of several fragments of equal depth those that did not
// fit into the buffer are skipped in the next pass, and what lies at depth 0 is skipped always. Amended, the order of
// submission decides between equal depths (errata LX01, LX04). Either way a pass that did not overflow is the last (erratum
// LX03), unless the text is read literally: then it waits until as many fragments are resolved as the list has, and is
// given up after more passes than it has fragments.
// defines: method

// Inserts with insertion sort. Stores at most N elements, drops the last element on overflow.
void insert(KEY key_f, uint place_f) {
#if INSERTION
    if (BEFORE(key_f, key[N - 1])) {
        insert_before(N - 1, key_f, place_f);
    }
#else
    // The same with constant indices: what is inserted pushes everything behind it one place on.
#define P(k) COMPARE(key[k], place[k], key_f, place_f)
#include "a_buffer/elements"
#endif
}

KEY min_key = BEFORE_ALL;    // set min depth to 0
uint left;                 // fragments that the subpass has not skipped

// Skips what was resolved before, inserts the rest; returns the place of the next record.
uint take(uint at, uint f, uint count) {
    if (f >= count) {
        return at;
    }
    uvec4 head = list_head(at);
    KEY key_f = key_of(head, at, f);
#if AS_PRINTED
    bool skip = depth_of(key_f) <= (min_key == BEFORE_ALL ? 0.0 : depth_of(min_key));
#else
    bool skip = !BEFORE(min_key, key_f);
#endif
    if (!skip) {
        insert(key_f, at);
        left += 1u;
    }
#if VOLUMES
    if (subpasses == 1u) {
        look_for_beginning(head.y);
    }
#endif
    return list_next(at);
}

void resolve_by_peeling(uint count) {
#if LITERAL
    uint resolved = 0u;
#endif
    do {
        clear_local_array(N);
        subpasses += 1u;
        records_read += count;
        left = 0u;
        uint at = list_first();
        // Four fragments at a time: see `methods/a_buffer/loops.rs`.
        for (uint f = 0u; f < count; f += 4u) {
            at = take(at, f, count);
            at = take(at, f + 1u, count);
            at = take(at, f + 2u, count);
            at = take(at, f + 3u, count);
        }
#if VOLUMES
        if (subpasses == 1u) {
            begin_ray();
        }
#endif
        resolve_local_array(min(left, uint(N)));
        min_key = key[N - 1];    // store min depth of last buffer element
        // A subpass resolves one fragment at least. What did not would go on for ever, and take the GPU with it.
#if LITERAL
        resolved += min(left, uint(N));
    } while (resolved < count && subpasses <= min(count, uint(MOST_SUBPASSES)) && !ray_ended());
#else
    } while (left > uint(N) && subpasses < min(count, uint(MOST_SUBPASSES)) && !ray_ended());
#endif
}
