// A list of places for each point. Blocks of 16 points interleave their lists, so that neighbouring lanes read
// neighbouring words: entry k of point p lies at ((p / 16) * capacity + k) * 16 + p % 16.

#define PELAGE_BLOCK 16

static inline long pelage_list_begin(int place, int capacity) {
    return (long)(place & ~(PELAGE_BLOCK - 1)) * capacity + (place & (PELAGE_BLOCK - 1));
}

// What does not fit is counted only.
static inline int pelage_list_append(__global int* list, int length, int capacity, int place) {
    if (length < capacity) list[length * PELAGE_BLOCK] = place;
    return length + 1;
}

// Shell's sort, by id: lists are short as a rule, but not in a crowd.
static inline void pelage_list_sort(__global int* list, int length, __global const int* ids) {
    const int gaps[8] = {701, 301, 132, 57, 23, 10, 4, 1};  // Ciura 2001
    for (int g = 0; g < 8; ++g) {
        const int gap = gaps[g];
        for (int i = gap; i < length; ++i) {
            const int place = list[i * PELAGE_BLOCK];
            const int id = ids[place];
            int k = i;
            while (k >= gap && ids[list[(k - gap) * PELAGE_BLOCK]] > id) {
                list[k * PELAGE_BLOCK] = list[(k - gap) * PELAGE_BLOCK];
                k -= gap;
            }
            list[k * PELAGE_BLOCK] = place;
        }
    }
}
