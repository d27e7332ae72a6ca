// Work-items of a group that work together.
//   PELAGE_ITEMS   how many there are: 1, 2, 4 ...

#if PELAGE_ITEMS == 1
#define ITEM 0
#define REDUCE(type, name, combine) \
    static inline type name(type v, local type* space) { return v; }
#define SPACE(type, name) local type* const name = 0
#define SYNC
#define SHARED restrict
#else
#define ITEM ((int)get_local_id(0))
#define REDUCE(type, name, combine)                                         \
    static inline type name(type v, local type* space) {                    \
        space[ITEM] = v;                                                    \
        barrier(CLK_LOCAL_MEM_FENCE);                                       \
        for (int half_way = PELAGE_ITEMS / 2; half_way > 0; half_way /= 2) { \
            if (ITEM < half_way) {                                          \
                const type a = space[ITEM], b = space[ITEM + half_way];     \
                space[ITEM] = combine;                                      \
            }                                                               \
            barrier(CLK_LOCAL_MEM_FENCE);                                   \
        }                                                                   \
        const type all = space[0];                                          \
        barrier(CLK_LOCAL_MEM_FENCE);                                       \
        return all;                                                         \
    }
#define SPACE(type, name) local type name[PELAGE_ITEMS]
#define SYNC barrier(CLK_GLOBAL_MEM_FENCE | CLK_LOCAL_MEM_FENCE)
// What items of a group tell each other is never `restrict`: a compiler would let each keep its own copy of it.
#define SHARED
#endif
REDUCE(long, pelage_least, min(a, b))
REDUCE(long, pelage_most, max(a, b))
REDUCE(long, pelage_sum_of, a + b)
