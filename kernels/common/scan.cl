// Exclusive prefix sums of counts, and how work is dealt out in chunks: one work-item a chunk.

// First element of a chunk; chunk == chunks gives the end. Chunks differ in length by one at most.
static inline int pelage_chunk_begin(int n, int chunk, int chunks) {
    return (int)((long)n * chunk / chunks);
}

// What all chunks before this one hold.
static inline int pelage_sum_before(__global const int* sums, int chunk) {
    int sum = 0;
    for (int i = 0; i < chunk; ++i) sum += sums[i];
    return sum;
}
