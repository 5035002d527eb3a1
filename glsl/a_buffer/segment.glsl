// Which pixels a complexity segment of N takes (ppAO).

// Those with more fragments than the segment before can take and no more than N.
bool in_segment(uint count) {
    uint before = N == FIRST_SEGMENT ? 0u : uint(N) / 2u;
    return before < count && count <= uint(N);
}
