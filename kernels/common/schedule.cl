// Stands before a program where PELAGE_SCHEDULE is set, see host/opencl/device/schedule.hpp: each work-group and each
// work-item does the work of another one of its launch, and who touches what others wait for lingers before and after.
//   PELAGE_SEED       what is drawn
//   PELAGE_REVERSED   the last comes first; otherwise the order is drawn

// Whose work number `id` of `count` does: one to one.
static inline size_t pelage_whose(size_t id, size_t count, uint dimension) {
#ifdef PELAGE_REVERSED
    return count - 1 - id;
#else
    uint mask = (uint)count - 1u;
    for (uint shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
    const uint key = (PELAGE_SEED + dimension) * 0x9E3779B9u;
    uint place = (uint)id;
    // One to one on 0 .. mask; gone on with until it meets a number below `count`, it is one to one on those, too.
    do {
        place = (place * 0x2C1B3C6Du + key) & mask;
        place ^= place >> 2;
        place = (place * 0x297A2D39u + (key >> 7)) & mask;
    } while (place >= (uint)count);
    return place;
#endif
}

static inline size_t pelage_group_of_schedule(uint dimension) {
    return pelage_whose(get_group_id(dimension), get_num_groups(dimension), dimension);
}

static inline size_t pelage_item_of_schedule(uint dimension) {
    return pelage_whose(get_local_id(dimension), get_local_size(dimension), dimension);
}

// Mostly for a moment, now and then for longer than others are patient. The store is what a compiler keeps.
static inline int pelage_linger(uint at) {
    uint dice = (uint)get_group_id(0) * 0x85EBCA6Bu + (uint)get_group_id(1) * 0xC2B2AE35u + at * 0x27D4EB2Fu + PELAGE_SEED;
    dice = (dice ^ (dice >> 15)) * 0x2C1B3C6Du;
    dice = (dice ^ (dice >> 12)) * 0x297A2D39u;
    dice ^= dice >> 15;
    const uint turns = dice >> 28 == 0 ? dice & 0x3fffu : dice & 0x3fu;
    volatile uint turn = 0;
    while (turn < turns) turn = turn + 1;
    return 0;
}

#define get_group_id(dimension) pelage_group_of_schedule(dimension)
#define get_local_id(dimension) pelage_item_of_schedule(dimension)
#define get_global_id(dimension) \
    (get_global_offset(dimension) + get_group_id(dimension) * get_local_size(dimension) + get_local_id(dimension))

// The same calls, with waits before and after them that differ by the numbers that they are of.
#define PELAGE_LATE(space, type)                                                                                \
    static inline type __attribute__((overloadable)) pelage_late_inc(volatile space type* place) {              \
        pelage_linger(1);                                                                                       \
        const type got = atomic_inc(place);                                                                     \
        pelage_linger(2 * (uint)got);                                                                           \
        return got;                                                                                             \
    }                                                                                                           \
    static inline type __attribute__((overloadable))                                                            \
    pelage_late_cmpxchg(volatile space type* place, type old, type new) {                                       \
        pelage_linger(3 * (uint)new);                                                                           \
        const type got = atomic_cmpxchg(place, old, new);                                                       \
        pelage_linger(5 * (uint)new);                                                                           \
        return got;                                                                                             \
    }                                                                                                           \
    PELAGE_LATE_WITH(space, type, late_add, atomic_add)                                                         \
    PELAGE_LATE_WITH(space, type, late_min, atomic_min)                                                         \
    PELAGE_LATE_WITH(space, type, late_max, atomic_max)                                                         \
    PELAGE_LATE_WITH(space, type, late_xchg, atomic_xchg)
#define PELAGE_LATE_WITH(space, type, late, atomic)                                                             \
    static inline type __attribute__((overloadable)) pelage_##late(volatile space type* place, type with) {     \
        pelage_linger(7 * (uint)with);                                                                          \
        const type got = atomic(place, with);                                                                   \
        pelage_linger(11 * (uint)with);                                                                         \
        return got;                                                                                             \
    }
PELAGE_LATE(__global, int)
PELAGE_LATE(__global, uint)
PELAGE_LATE(__local, int)
PELAGE_LATE(__local, uint)
// Some drivers have macros of these names.
#undef atomic_inc
#undef atomic_cmpxchg
#undef atomic_add
#undef atomic_min
#undef atomic_max
#undef atomic_xchg
#define atomic_inc pelage_late_inc
#define atomic_cmpxchg pelage_late_cmpxchg
#define atomic_add pelage_late_add
#define atomic_min pelage_late_min
#define atomic_max pelage_late_max
#define atomic_xchg pelage_late_xchg

// Of lattice/together.cl: with an odd seed, groups soon take what others should do.
#if PELAGE_SEED % 2 == 1
#define PATIENCE 3
#endif
