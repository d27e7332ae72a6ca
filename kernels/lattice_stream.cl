// Several iterations of a lattice in one pass over memory: a streaming wavefront.
// A work-group walks up a band of columns in blocks of PELAGE_BLOCK rows. Of each block it takes `steps` time levels in
// scratch: level l reads the block that level l - 1 left and writes rows that lie l rows lower, so that what it needs of
// the rows below is what it carried along from the block before. Around its part of the lattice a group computes a
// margin of `steps` cells that narrows by one each level; cells beyond the edge are the ones that the
// boundary puts there (a mirrored or wrapped cell evolves exactly like its original, random draws included).
// `passes` may exceed 1 only where one work-group does all of the lattice: then nobody else reads what is written.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/emit_stream.hpp.
//   PELAGE_DEPTH     most levels of a launch
//   PELAGE_BLOCK     rows of a block
//   PELAGE_VECTORS   most vectors across a band, margins included
//   PELAGE_FIELDS    values of a cell that pass through: concentrations, rates, polarity, mappings
//   PELAGE_CARRIED   vectors that a level carries from block to block, for each vector across
//   PELAGE_SEEN      fields, the first ones, whose neighbouring values are looked at one by one
//   PELAGE_VISITS    there are such

// Planes begin 16 elements into their buffer, each with a row of zeros.
#define PLANE(buffer, nth) ((buffer) + 16 + (nth) * plane + pitch)

// Scratch rows begin an odd multiple of 128 bytes apart: a power of two would make them share cache sets.
#define LINE (128 / (int)sizeof(scalar))
#define SLOT ((((PELAGE_VECTORS * PELAGE_WIDTH + LINE - 1) / LINE) | 1) * LINE)
// Rows -2 and -1 of the scratch are the last two of the block before.
#ifdef PELAGE_VISITS
#define KEPT 2
#else
#define KEPT 0
#endif
#define SCRATCH_SIZE (2 * (PELAGE_BLOCK + KEPT) * PELAGE_FIELDS * SLOT + 32)
#define CARRY_SIZE (PELAGE_DEPTH * PELAGE_VECTORS * (PELAGE_CARRIED + KEPT * PELAGE_SEEN) * PELAGE_WIDTH)
#define SCRATCH(parity, r, field) \
    (scratch + 16 + (((parity) * (PELAGE_BLOCK + KEPT) + KEPT + (r)) * PELAGE_FIELDS + (field)) * SLOT)

// The column or row that stands for `i`, which may lie beyond the edges; `beyond` where it stands for nothing.
static inline int pelage_stands_for(int i, int count, int beyond) {
#if defined(PELAGE_WRAP)
    if (i < 0) i += count;
    if (i >= count) i -= count;
#elif defined(PELAGE_NO_FLUX)
    if (i < 0) i = -1 - i;
    if (i >= count) i = 2 * count - 1 - i;
#else
    if (i < 0 || i >= count) return beyond;
#endif
    return clamp(i, 0, count - 1);
}

// Elements of a row at x .. x + PELAGE_WIDTH - 1, by what stands for them. Past a row's cells lies a 0.
static inline real pelage_gather(global const scalar* row, int x, int columns) {
    scalar lanes[PELAGE_WIDTH];
    #pragma unroll 1
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = row[pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, columns)];
    }
    return LOAD(lanes);
}

static inline real pelage_fetch(global const scalar* row, int x, int columns) {
    return x >= 0 && x + PELAGE_WIDTH <= columns ? LOAD(row + x) : pelage_gather(row, x, columns);
}

static inline intv pelage_fetch_whole(global const int* row, int x, int columns) {
    int lanes[PELAGE_WIDTH];
    #pragma unroll 1
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = row[pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, columns)];
    }
    return LOAD(lanes);
}

static inline uintv pelage_columns(int x, int columns) {
    uint lanes[PELAGE_WIDTH];
    #pragma unroll 1
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = (uint)pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, 0);
    }
    return LOAD(lanes);
}

// Cells of v at x .. that belong to [from, to) go to the row.
static inline void pelage_put(real v, global scalar* row, int x, int from, int to) {
    if (x >= from && x + PELAGE_WIDTH <= to) {
        STORE(v, row + x);
        return;
    }
    scalar lanes[PELAGE_WIDTH];
    STORE(v, lanes);
    #pragma unroll 1
    for (int k = max(from - x, 0); k < min(to - x, PELAGE_WIDTH); ++k) row[x + k] = lanes[k];
}

#define GET_NEIGHBOURS TO_REAL(pelage_fetch_whole(neighbours + (long)row * pitch, x, columns))
#define GET_BIRTH TO_REAL(pelage_fetch_whole(birth + (long)row * pitch, x, columns))
#define GET_AGE TO_REAL((uintv)(iteration)-TO_UINT(pelage_fetch_whole(birth + (long)row * pitch, x, columns)))
#define GET_X place_x
#define GET_Y R(places[pitch + row])
#define GET_ROW R((scalar)row)
#define GET_COLUMN TO_REAL(column)
#define GET_ROWS R((scalar)rows)
#define GET_COLUMNS R((scalar)columns)

// Chemical i lies in field `at` of the scratch. What a level carries of it: the sums of the rows below and here and the
// cells here; of one that does not diffuse, the cells alone.
#define TAKE(i, at) const real up##i = LOAD(above + (at) * SLOT);
#define TAKE_SUM(i, at) \
    const real up_sum##i = ROW_SUM(LOAD(above + (at) * SLOT - 1), up##i, LOAD(above + (at) * SLOT + 1));
#define CARRY(nth) (carry + ((level * PELAGE_VECTORS + c) * (PELAGE_CARRIED + KEPT * PELAGE_SEEN) + (nth)) * PELAGE_WIDTH)
#define CARRY_ROW(field, r) CARRY(PELAGE_CARRIED + 2 * (field) + (r))

kernel __attribute__((reqd_work_group_size(PELAGE_GROUP, 1, 1))) void pelage_lattice_stream(
    global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate, global scalar* odd_rate,
    global scalar* even_polarity, global scalar* odd_polarity, global scalar* even_mapping, global scalar* odd_mapping,
    global const int* birth, global const int* neighbours, global const scalar* places,
    global const scalar* parameters, const int columns, const int rows, const int pitch, const int vectors,
    const int strip, const uint first, const int steps, const int passes, const uint seed_low, const uint seed_high) {
    local scalar scratch[SCRATCH_SIZE] __attribute__((aligned(128)));
    local scalar carry[CARRY_SIZE] __attribute__((aligned(128)));
    const int lane = (int)get_local_id(0);
    const long plane = (long)pitch * (rows + 1);
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    //@ parameters
    const int inner = vectors * PELAGE_WIDTH - 2 * steps;
    const int x0 = (int)get_group_id(0) * inner - steps;
    const int low = (int)get_group_id(1) * strip;
    const int high = min(low + strip, rows);
    const int blocks = (high - low + 2 * steps + PELAGE_BLOCK - 1) / PELAGE_BLOCK;
    // Nothing of what is cleared here reaches the lattice; it only must be a number.
    for (int i = lane; i < SCRATCH_SIZE; i += PELAGE_GROUP) scratch[i] = 0;
    for (int i = lane; i < CARRY_SIZE; i += PELAGE_GROUP) carry[i] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int pass = 0; pass < passes; ++pass) {
        //@ planes
        for (int block = 0; block < blocks; ++block) {
            const int base = low - steps + block * PELAGE_BLOCK;
            for (int r = 0; r < PELAGE_BLOCK; ++r) {
                const long there = (long)pelage_stands_for(min(base + r, rows + steps - 1), rows, -1) * pitch;
                for (int c = lane; c < vectors; c += PELAGE_GROUP) {
                    const int x = x0 + c * PELAGE_WIDTH;
                    //@ fetch
                }
            }
            barrier(CLK_LOCAL_MEM_FENCE);
            // A level has nothing to do before the rows it needs have come by.
            const int levels = min(steps, (block * PELAGE_BLOCK + PELAGE_BLOCK - 1) / 2 + 1);
            for (int level = 0; level < levels; ++level) {
                const int step = pass * steps + level;
                const uint iteration = first + (uint)step;
#ifdef PELAGE_PREFETCH
                // The rows of the next block are on their way while this one is worked on.
                if (level < PELAGE_BLOCK) {
                    const int next = min(base + PELAGE_BLOCK + level, rows + steps - 1);
                    const long there = (long)pelage_stands_for(next, rows, -1) * pitch;
                    const int end = min(x0 + vectors * PELAGE_WIDTH, columns);
                    for (int x = max(x0, 0); x < end; x += LINE / 2) {
                        //@ prefetch
                    }
                }
#endif
#ifdef PELAGE_VISITS
                for (int c = lane; c < vectors; c += PELAGE_GROUP) {
                    for (int field = 0; field < PELAGE_SEEN; ++field) {
                        for (int r = 0; r < 2; ++r) {
                            STORE(LOAD(CARRY_ROW(field, r)),
                                  SCRATCH(level & 1, r - 2, field) + c * PELAGE_WIDTH);
                        }
                    }
                }
                barrier(CLK_LOCAL_MEM_FENCE);
#endif
                for (int c = lane; c < vectors; c += PELAGE_GROUP) {
                    const int x = x0 + c * PELAGE_WIDTH;
                    //@ resume
                    //@ unroll
                    for (int r = 0; r < PELAGE_BLOCK; ++r) {
                        local const scalar* const above = SCRATCH(level & 1, r, 0) + c * PELAGE_WIDTH;
                        local scalar* const result = SCRATCH(~level & 1, r, 0) + c * PELAGE_WIDTH;
                        //@ row
                        //@ cell
                        //@ rules
                        //@ diffusion
#ifdef PELAGE_VISITS
                        const int flipped = MIRRORS ? row != at_row : 0;
                        for (int k = 0; k < 3; ++k) {
                            const int up = pelage_up(k, row, rows);
                            const int beyond = row + up < 0 || row + up >= rows;
#ifdef PELAGE_NO_FLUX
                            if (beyond) continue;
#endif
                            // A mirrored row has its neighbours the other way round.
                            const int there = (flipped ? -up : up) * PELAGE_FIELDS * SLOT;
                            for (int side = -1; side <= 1; ++side) {
#ifdef PELAGE_FIVE_POINT
                                if ((up == 0) == (side == 0)) continue;
#else
                                if (up == 0 && side == 0) continue;
#endif
                                const mask inside = pelage_inside_column(column, columns, side, beyond);
                                const real dx = R((scalar)(2 * side));
                                const real dy = R((scalar)(2 * up));
                                const int diagonal = up != 0 && side != 0;
                                const real norm = diagonal ? R(PELAGE_SQRT_8) : R(2);
                                const real neighbour_share = diagonal ? DIAGONAL_SHARE : EDGE_SHARE;
                                //@ visit
                            }
                        }
#endif
                        //@ replace
                        //@ finish
                    }
                    //@ suspend
                }
#ifdef PELAGE_VISITS
                for (int c = lane; c < vectors; c += PELAGE_GROUP) {
                    for (int field = 0; field < PELAGE_SEEN; ++field) {
                        for (int r = 0; r < 2; ++r) {
                            STORE(LOAD(SCRATCH(level & 1, PELAGE_BLOCK - 2 + r, field) + c * PELAGE_WIDTH),
                                  CARRY_ROW(field, r));
                        }
                    }
                }
#endif
                barrier(CLK_LOCAL_MEM_FENCE);
            }
            if (levels < steps) continue;
            for (int r = 0; r < PELAGE_BLOCK; ++r) {
                const int row = base + r - steps;
                if (row < low || row >= high) continue;
                const long there = (long)row * pitch;
                for (int c = lane; c < vectors; c += PELAGE_GROUP) {
                    const int x = x0 + c * PELAGE_WIDTH;
                    const int from = x0 + steps;
                    const int to = min(from + inner, columns);
                    //@ put
                }
            }
            barrier(CLK_LOCAL_MEM_FENCE);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
