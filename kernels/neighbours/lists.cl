// Neighbour lists of points sorted into bins: for each point the places of all others nearer than a radius (strictly),
// ascending by id; see common/list.cl.

#if PELAGE_WIDTH == 16

// The lanes or-ed together.
static inline uint pelage_or_of(uint16 v) {
    const uint8 eight = v.lo | v.hi;
    const uint4 four = eight.lo | eight.hi;
    const uint2 two = four.lo | four.hi;
    return two.x | two.y;
}

#define PELAGE_BITS \
    ((uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768))

// Lane k holds `bits` of lane k where point begin + k is near, else 0.
static inline uint16 pelage_near_lanes(__global const scalar* x, __global const scalar* y, int begin, scalar centre_x,
                                       scalar centre_y, scalar square, uint16 bits) {
    const real dx = LOAD(x + begin) - centre_x;
    const real dy = LOAD(y + begin) - centre_y;
    return as_uint16(convert_int16(dx * dx + dy * dy < square)) & bits;
}

// The lowest `count` bits, of at most 16.
static inline uint pelage_lowest(int count) { return (1u << min(count, 16)) - 1u; }

// Bit k: point begin + k is near and comes before end.
static inline uint pelage_near(__global const scalar* x, __global const scalar* y, int begin, int end,
                               scalar centre_x, scalar centre_y, scalar square) {
    return pelage_or_of(pelage_near_lanes(x, y, begin, centre_x, centre_y, square, PELAGE_BITS)) &
           pelage_lowest(end - begin);
}

// As pelage_near, for up to 32 points.
static inline uint pelage_near_32(__global const scalar* x, __global const scalar* y, int begin, int end,
                                  scalar centre_x, scalar centre_y, scalar square) {
    const uint first = pelage_near(x, y, begin, end, centre_x, centre_y, square);
    if (end - begin <= 16) return first;
    return first | pelage_near(x, y, begin + 16, end, centre_x, centre_y, square) << 16;
}

// The places of the lowest 8 bits of a mask, of which bit 16 k + i stands for point i of run k; they are taken away.
static inline int8 pelage_next_8(ulong* mask, int begin_0, int begin_1, int begin_2) {
    int bits[8];
    ulong left = *mask;
    #pragma unroll
    for (int j = 0; j < 8; ++j) {
        bits[j] = (int)popcount(~left & (left - 1));
        left &= left - 1;
    }
    *mask = left;
    const int8 bit = vload8(0, bits);
    const int8 first = select((int8)(begin_0), (int8)(begin_1 - 16), bit >= 16);
    return bit + select(first, (int8)(begin_2 - 32), bit >= 32);
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

// From the last lane to the first: what lies past the list's end is written first, and over.
static inline void pelage_list_scatter(__global int* list, int capacity, int16 ranks, int16 places) {
    const int16 rank = min(ranks, capacity - 1);
    PELAGE_STORE4(sf, se, sd, sc)
    PELAGE_STORE4(sb, sa, s9, s8)
    PELAGE_STORE4(s7, s6, s5, s4)
    PELAGE_STORE4(s3, s2, s1, s0)
}

// At most 8 places, sorted by rank. Lanes past `length` store the point itself behind them.
static inline void pelage_list_store_8(__global int* list, int8 found, int length, int self,
                                       __global const int* ids) {
    const int8 lane = (int8)(0, 1, 2, 3, 4, 5, 6, 7);
    const int8 places = select((int8)self, found, lane < length);
    const int8 rank = pelage_before_8(select(0x7fffffc0 + lane, PELAGE_IDS_8(places), lane < length));
    PELAGE_STORE4(s0, s1, s2, s3)
    PELAGE_STORE4(s4, s5, s6, s7)
}

// The same for at most 32 places.
static inline void pelage_list_store(__global int* list, int capacity, const int* found, int length, int self,
                                     __global const int* ids) {
    const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const int16 last = 0x7fffffc0 + lane;
    const int16 places = select((int16)self, LOAD(found), lane < length);
    const int16 order = select(last, PELAGE_IDS(places), lane < length);
    if (length <= 16) {
        pelage_list_scatter(list, capacity, pelage_before(order, order), places);
        return;
    }
    const int16 more_places = select((int16)self, LOAD(found + 16), lane + 16 < length);
    const int16 more_order = select(last + 16, PELAGE_IDS(more_places), lane + 16 < length);
    pelage_list_scatter(list, capacity, pelage_before(order, more_order) + pelage_before(more_order, more_order),
                        more_places);
    pelage_list_scatter(list, capacity, pelage_before(order, order) + pelage_before(more_order, order), places);
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
    // The points of the 3 x 3 bins around are three runs: below, beside and above. One beyond the edge is empty.
    const int left = row * grid.columns + max(column - 1, 0);
    const int right = row * grid.columns + min(column + 1, grid.columns - 1) + 1;
    const int under = row > 0 ? grid.columns : 0;
    const int over = row + 1 < grid.rows ? grid.columns : 0;
    const int begin_0 = starts[left - under];
    const int end_0 = under ? starts[right - under] : begin_0;
    const int begin_1 = starts[left];
    const int end_1 = starts[right];
    const int begin_2 = starts[left + over];
    const int end_2 = over ? starts[right + over] : begin_2;
    __global int* restrict list = lists + pelage_list_begin(self, capacity);
    int length = 0;
#if PELAGE_WIDTH == 16
    const int longest_run = max(max(end_0 - begin_0, end_1 - begin_1), end_2 - begin_2);
    // Most runs have at most 16 points: all three are then one mask, bit 16 k + i for point i of run k.
    if (longest_run <= 16) {
        const uint16 below = pelage_near_lanes(x, y, begin_0, centre_x, centre_y, square, PELAGE_BITS);
        const uint16 beside = pelage_near_lanes(x, y, begin_1, centre_x, centre_y, square, PELAGE_BITS << 16);
        const uint above = pelage_near(x, y, begin_2, end_2, centre_x, centre_y, square);
        const uint inside = pelage_lowest(end_0 - begin_0) | pelage_lowest(end_1 - begin_1) << 16;
        const uint self_bit = 1u << (self - begin_1 + 16);
        ulong mask = (ulong)(pelage_or_of(below | beside) & inside & ~self_bit) | (ulong)above << 32;
        length = (int)popcount(mask);
        if (length <= 8 && capacity >= 8) {  // as in most tissues
            pelage_list_store_8(list, pelage_next_8(&mask, begin_0, begin_1, begin_2), length, self, ids);
            lengths[self] = length;
            return;
        }
        if (length <= min(capacity, 32)) {
            int found[32];
            for (int i = 0; i < length; i += 8) {
                vstore8(pelage_next_8(&mask, begin_0, begin_1, begin_2), 0, found + i);
            }
            pelage_list_store(list, capacity, found, length, self, ids);
            lengths[self] = length;
            return;
        }
        length = 0;
    }
#endif
    const int begin[3] = {begin_0, begin_1, begin_2};
    const int end[3] = {end_0, end_1, end_2};
#if PELAGE_WIDTH == 16
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
        if (length <= min(capacity, 32)) {
            pelage_list_store(list, capacity, found, length, self, ids);
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
