// Neighbour lists of points sorted into bins: for each point the places of all others nearer than a radius (strictly),
// ascending by id. Blocks of 16 points interleave their lists, so that neighbouring lanes read neighbouring words:
// entry k of point p lies at ((p / 16) * capacity + k) * 16 + p % 16.

#define PELAGE_BLOCK 16

inline long pelage_list_begin(int place, int capacity) {
    return (long)(place / PELAGE_BLOCK) * capacity * PELAGE_BLOCK + place % PELAGE_BLOCK;
}

// A list that is kept sorted by id while it grows. What does not fit is counted only.
inline int pelage_list_insert(__global int* restrict list, int length, int capacity, int place,
                              __global const int* restrict ids) {
    if (length < capacity) {
        const int id = ids[place];
        int k = length;
        while (k > 0 && ids[list[(k - 1) * PELAGE_BLOCK]] > id) {
            list[k * PELAGE_BLOCK] = list[(k - 1) * PELAGE_BLOCK];
            --k;
        }
        list[k * PELAGE_BLOCK] = place;
    }
    return length + 1;
}

#if PELAGE_WIDTH == 16

inline uint pelage_mask_of(int16 lanes) {
    const uint16 bits = as_uint16(lanes) & (uint16)(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384, 32768);
    const uint8 eight = bits.lo | bits.hi;
    const uint4 four = eight.lo | eight.hi;
    const uint2 two = four.lo | four.hi;
    return two.x | two.y;
}

// Bit k: point begin + k is near and comes before end.
inline uint pelage_near(__global const scalar* restrict x, __global const scalar* restrict y, int begin, int end,
                        scalar centre_x, scalar centre_y, scalar square) {
    const real dx = vload16(0, x + begin) - centre_x;
    const real dy = vload16(0, y + begin) - centre_y;
    const uint near = pelage_mask_of(convert_int16(dx * dx + dy * dy < square));
    return end - begin < 16 ? near & ((1u << (end - begin)) - 1u) : near;
}

// Place of each lane among the sixteen when they are sorted.
inline int16 pelage_ranks(int16 v) {
    int16 rank = 0;
    rank -= v.s123456789abcdef0 < v;
    rank -= v.s23456789abcdef01 < v;
    rank -= v.s3456789abcdef012 < v;
    rank -= v.s456789abcdef0123 < v;
    rank -= v.s56789abcdef01234 < v;
    rank -= v.s6789abcdef012345 < v;
    rank -= v.s789abcdef0123456 < v;
    rank -= v.s89abcdef01234567 < v;
    rank -= v.s9abcdef012345678 < v;
    rank -= v.sabcdef0123456789 < v;
    rank -= v.sbcdef0123456789a < v;
    rank -= v.scdef0123456789ab < v;
    rank -= v.sdef0123456789abc < v;
    rank -= v.sef0123456789abcd < v;
    rank -= v.sf0123456789abcde < v;
    return rank;
}

#define PELAGE_STORE(lane) list[rank.lane * PELAGE_BLOCK] = places.lane;
#define PELAGE_STORE4(a, b, c, d) PELAGE_STORE(a) PELAGE_STORE(b) PELAGE_STORE(c) PELAGE_STORE(d)

// At most sixteen places at once; the lanes past `length` store the point itself behind them.
inline void pelage_list_store(__global int* restrict list, const int* found, int length, int self,
                              __global const int* restrict ids) {
    const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const int16 places = select((int16)self, vload16(0, found), lane < length);
    const int16 all = (int16)(ids[places.s0], ids[places.s1], ids[places.s2], ids[places.s3], ids[places.s4],
                              ids[places.s5], ids[places.s6], ids[places.s7], ids[places.s8], ids[places.s9],
                              ids[places.sa], ids[places.sb], ids[places.sc], ids[places.sd], ids[places.se],
                              ids[places.sf]);
    const int16 rank = pelage_ranks(select(0x7ffffff0 + lane, all, lane < length));
    PELAGE_STORE4(s0, s1, s2, s3)
    PELAGE_STORE4(s4, s5, s6, s7)
    PELAGE_STORE4(s8, s9, sa, sb)
    PELAGE_STORE4(sc, sd, se, sf)
}

#endif

// longest[0] grows to the longest list, also past the capacity: the caller then makes room and repeats.
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
    // Nearly always each run has at most 16 points and the list at most 16 entries: three masks say it all.
    if (max(max(end[0] - begin[0], end[1] - begin[1]), end[2] - begin[2]) <= 16) {
        const ulong below = pelage_near(x, y, begin[0], end[0], centre_x, centre_y, square);
        const ulong beside = pelage_near(x, y, begin[1], end[1], centre_x, centre_y, square) & ~(1ul << (self - begin[1]));
        const ulong above = pelage_near(x, y, begin[2], end[2], centre_x, centre_y, square);
        const int in_two = (int)(popcount(below) + popcount(beside));
        length = in_two + (int)popcount(above);
        if (length <= 16) {
            const int in_one = (int)popcount(below);
            ulong mask = below | (beside << 16) | (above << 32);
            int found[16];
            for (int group = 0; group < length; group += 8) {
                #pragma unroll
                for (int k = group; k < group + 8; ++k) {
                    const int bit = 63 - (int)clz(mask & -mask);
                    mask &= mask - 1;
                    found[k] = bit + (k < in_one ? begin[0] : k < in_two ? begin[1] - 16 : begin[2] - 32);
                }
            }
            pelage_list_store(list, found, length, self, ids);
            lengths[self] = length;
            if (length > longest[0]) atomic_max(longest, length);
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
                if (other != self) length = pelage_list_insert(list, length, capacity, other, ids);
            }
        }
    }
#else
    for (int k = 0; k < 3; ++k) {
        for (int other = begin[k]; other < end[k]; ++other) {
            const scalar dx = x[other] - centre_x;
            const scalar dy = y[other] - centre_y;
            if (dx * dx + dy * dy < square && other != self) {
                length = pelage_list_insert(list, length, capacity, other, ids);
            }
        }
    }
#endif
    lengths[self] = length;
    if (length > longest[0]) atomic_max(longest, length);
}
