// Neighbour lists of points sorted into bins: for each point the places of all others nearer than a radius (strictly),
// ascending by id. Blocks of 16 points interleave their lists, so that neighbouring lanes read neighbouring words:
// entry k of point p lies at ((p / 16) * capacity + k) * 16 + p % 16.

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

#if PELAGE_WIDTH == 16

static inline uint pelage_mask_of(int16 lanes) {
    const uint16 bit = (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
    const uint16 bits = as_uint16(lanes) & bit;
    const uint8 eight = bits.lo | bits.hi;
    const uint4 four = eight.lo | eight.hi;
    const uint2 two = four.lo | four.hi;
    return two.x | two.y;
}

// Bit k: point begin + k is near and comes before end.
static inline uint pelage_near(__global const scalar* x, __global const scalar* y, int begin, int end,
                        scalar centre_x, scalar centre_y, scalar square) {
    const real dx = LOAD(x + begin) - centre_x;
    const real dy = LOAD(y + begin) - centre_y;
    const uint near = pelage_mask_of(convert_int16(dx * dx + dy * dy < square));
    return end - begin < 16 ? near & ((1u << (end - begin)) - 1u) : near;
}

// As pelage_near, for up to 32 points.
static inline uint pelage_near_32(__global const scalar* x, __global const scalar* y, int begin, int end,
                           scalar centre_x, scalar centre_y, scalar square) {
    const uint first = pelage_near(x, y, begin, end, centre_x, centre_y, square);
    if (end - begin <= 16) return first;
    return first | pelage_near(x, y, begin + 16, end, centre_x, centre_y, square) << 16;
}

// For each lane of v how many of `all` come before it.
static inline int16 pelage_before(int16 all, int16 v) {
    int16 count = -(all < v);
    count -= all.s123456789abcdef0 < v;
    count -= all.s23456789abcdef01 < v;
    count -= all.s3456789abcdef012 < v;
    count -= all.s456789abcdef0123 < v;
    count -= all.s56789abcdef01234 < v;
    count -= all.s6789abcdef012345 < v;
    count -= all.s789abcdef0123456 < v;
    count -= all.s89abcdef01234567 < v;
    count -= all.s9abcdef012345678 < v;
    count -= all.sabcdef0123456789 < v;
    count -= all.sbcdef0123456789a < v;
    count -= all.scdef0123456789ab < v;
    count -= all.sdef0123456789abc < v;
    count -= all.sef0123456789abcd < v;
    count -= all.sf0123456789abcde < v;
    return count;
}

static inline int8 pelage_before_8(int8 all) {
    int8 count = -(all.s12345670 < all);
    count -= all.s23456701 < all;
    count -= all.s34567012 < all;
    count -= all.s45670123 < all;
    count -= all.s56701234 < all;
    count -= all.s67012345 < all;
    count -= all.s70123456 < all;
    return count;
}

#define PELAGE_IDS_8(places)                                                                                \
    (int8)(ids[places.s0], ids[places.s1], ids[places.s2], ids[places.s3], ids[places.s4], ids[places.s5], \
           ids[places.s6], ids[places.s7])
#define PELAGE_IDS(places)                                                                                        \
    (int16)(ids[places.s0], ids[places.s1], ids[places.s2], ids[places.s3], ids[places.s4], ids[places.s5],       \
            ids[places.s6], ids[places.s7], ids[places.s8], ids[places.s9], ids[places.sa], ids[places.sb],       \
            ids[places.sc], ids[places.sd], ids[places.se], ids[places.sf])
#define PELAGE_STORE(lane) list[rank.lane * PELAGE_BLOCK] = places.lane;
#define PELAGE_STORE4(a, b, c, d) PELAGE_STORE(a) PELAGE_STORE(b) PELAGE_STORE(c) PELAGE_STORE(d)

static inline void pelage_list_scatter(__global int* list, int16 rank, int16 places) {
    PELAGE_STORE4(s0, s1, s2, s3)
    PELAGE_STORE4(s4, s5, s6, s7)
    PELAGE_STORE4(s8, s9, sa, sb)
    PELAGE_STORE4(sc, sd, se, sf)
}

// At most 32 places, sorted by rank. Lanes past `length` store the point itself behind them: room for 16 or 32 entries.
// Of most tissues lists have 8 at most.
static inline void pelage_list_store(__global int* list, const int* found, int length, int self,
                              __global const int* ids) {
    if (length <= 8) {
        const int8 eight = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
        const int8 few = select((int8)self, vload8(0, found), eight < length);
        const int8 rank = pelage_before_8(select(0x7fffffc0 + eight, PELAGE_IDS_8(few), eight < length));
        const int8 places = few;
        PELAGE_STORE4(s0, s1, s2, s3)
        PELAGE_STORE4(s4, s5, s6, s7)
        return;
    }
    const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const int16 last = 0x7fffffc0 + lane;
    const int16 places = select((int16)self, LOAD(found), lane < length);
    const int16 order = select(last, PELAGE_IDS(places), lane < length);
    if (length <= 16) {
        pelage_list_scatter(list, pelage_before(order, order), places);
        return;
    }
    const int16 more_places = select((int16)self, LOAD(found + 16), lane + 16 < length);
    const int16 more_order = select(last + 16, PELAGE_IDS(more_places), lane + 16 < length);
    pelage_list_scatter(list, pelage_before(order, order) + pelage_before(more_order, order), places);
    pelage_list_scatter(list, pelage_before(order, more_order) + pelage_before(more_order, more_order), more_places);
}

#endif

// longest[0] grows to the longest list that does not fit: the caller then makes room and repeats.
__kernel void pelage_neighbours_lists(__global const scalar* restrict positions, int pitch,
                                      __global const int* restrict ids, __global const int* restrict starts, int n,
                                      __global const struct pelage_grid* restrict grid_in, scalar square, int capacity,
                                      __global int* restrict lengths, __global int* restrict lists,
                                      __global int* restrict longest) {
    const int self = (int)get_global_id(0);
    if (self >= n) {  // lanes of the last block without a point
        if (self / PELAGE_BLOCK == (n - 1) / PELAGE_BLOCK) lengths[self] = 0;
        return;
    }
    __global const scalar* restrict x = positions;
    __global const scalar* restrict y = positions + pitch;
    const struct pelage_grid grid = *grid_in;
    const scalar centre_x = x[self];
    const scalar centre_y = y[self];
    const int column = pelage_bin_along(centre_x, grid.x, grid.per_x, grid.columns);
    const int row = pelage_bin_along(centre_y, grid.y, grid.per_y, grid.rows);
    const int left = max(column - 1, 0);
    const int right = min(column + 1, grid.columns - 1);
    int begin[3], end[3];
    for (int k = 0; k < 3; ++k) {
        const int other = row + k - 1;
        const int inside = other >= 0 && other < grid.rows;
        begin[k] = inside ? starts[other * grid.columns + left] : 0;
        end[k] = inside ? starts[other * grid.columns + right + 1] : 0;
    }
    __global int* restrict list = lists + pelage_list_begin(self, capacity);
    int length = 0;
#if PELAGE_WIDTH == 16
    const int longest_run = max(max(end[0] - begin[0], end[1] - begin[1]), end[2] - begin[2]);
    // Most runs have at most 16 points: all three are then one mask, bit 16 k + i for point i of run k.
    if (longest_run <= 16) {
        int found[48];
        int base[4] = {0, 0, 0, 0};
        ulong mask = 0;
        for (int k = 0; k < 3; ++k) {
            base[k] = begin[k] - 16 * k;
            mask |= (ulong)pelage_near(x, y, begin[k], end[k], centre_x, centre_y, square) << (16 * k);
        }
        mask &= ~((ulong)1 << (self - begin[1] + 16));
        length = (int)popcount(mask);
        if (length <= min(capacity & ~15, 32)) {
            for (int i = 0; i < length; i += 8) {
                #pragma unroll
                for (int j = 0; j < 8; ++j) {
                    const int bit = (63 - (int)clz(mask & -mask)) & 63;
                    found[i + j] = base[bit >> 4] + bit;
                    mask &= mask - 1;
                }
            }
            pelage_list_store(list, found, length, self, ids);
            lengths[self] = length;
            return;
        }
        length = 0;
    }
    // Nearly all others have at most 32 points, and the list as many entries.
    if (longest_run <= 32) {
        int found[48];
        for (int k = 0; k < 3 && length <= 32; ++k) {
            uint mask = pelage_near_32(x, y, begin[k], end[k], centre_x, centre_y, square);
            if (k == 1) mask &= ~(1u << (self - begin[1]));
            const int count = (int)popcount(mask);
            if (length + count <= 32) {
                for (int i = 0; i < count; i += 4) {
                    #pragma unroll
                    for (int j = 0; j < 4; ++j) {
                        found[length + i + j] = begin[k] + 31 - (int)clz(mask & -mask);
                        mask &= mask - 1;
                    }
                }
            }
            length += count;
        }
        if (length <= min(capacity & ~15, 32)) {
            pelage_list_store(list, found, length, self, ids);
            lengths[self] = length;
            return;
        }
        length = 0;
    }
    for (int k = 0; k < 3; ++k) {
        for (int first = begin[k]; first < end[k]; first += 16) {
            uint mask = pelage_near(x, y, first, end[k], centre_x, centre_y, square);
            while (mask != 0) {
                const int other = first + 31 - (int)clz(mask & -mask);
                mask &= mask - 1;
                if (other != self) length = pelage_list_append(list, length, capacity, other);
            }
        }
    }
#else
    for (int k = 0; k < 3; ++k) {
        for (int other = begin[k]; other < end[k]; ++other) {
            const scalar dx = x[other] - centre_x;
            const scalar dy = y[other] - centre_y;
            if (dx * dx + dy * dy < square && other != self) {
                length = pelage_list_append(list, length, capacity, other);
            }
        }
    }
#endif
    pelage_list_sort(list, min(length, capacity), ids);
    lengths[self] = length;
    if (length > capacity) atomic_max(longest, length);
}
