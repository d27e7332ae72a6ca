// Several iterations of a lattice in one pass over memory: a streaming wavefront.
// A work-group walks up a band of columns in blocks of PELAGE_BLOCK rows. Of each block it takes `steps` time levels in
// scratch: level l reads the block that level l - 1 left and writes rows that lie l rows lower, so that what it needs of
// the rows below is what it carried along from the block before. Around its part of the lattice a group computes a
// margin of `steps` cells that narrows by one each level; cells beyond the edge are the ones that the
// boundary puts there (a mirrored or wrapped cell evolves exactly like its original, random draws included).
// A band as wide as the lattice needs no `margin` of columns: before each level the column beside either edge is copied.
// `passes` may exceed 1 only where one work-group does all of the lattice: then nobody else reads what is written; or
// with PELAGE_TOGETHER and `strips` above 0, where work-groups of one work-item share the passes of so many strips and
// wait for each other, see lattice/together.cl.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/lattice/emit_fused.hpp.
//   PELAGE_BLOCK     rows of a block
//   PELAGE_VECTORS   most vectors across a band, margins included
//   PELAGE_CARRIED   vectors that a level carries from block to block, for each vector across

// Scratch rows begin an odd multiple of 128 bytes apart: a power of two would make them share cache sets.
#define LINE (128 / (int)sizeof(scalar))
// With room for one cell more on either side.
#define SLOT ((((PELAGE_VECTORS * PELAGE_WIDTH + 2 + LINE - 1) / LINE) | 1) * LINE)
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

// What a level carries of a chemical: the sums of the rows below and here and the cells here; of one that does not
// diffuse, the cells alone.
#define CARRY(nth) (carry + ((level * PELAGE_VECTORS + c) * (PELAGE_CARRIED + KEPT * PELAGE_SEEN) + (nth)) * PELAGE_WIDTH)
#define CARRY_ROW(field, r) CARRY(PELAGE_CARRIED + 2 * (field) + (r))
#define RESUME(name, at, nth) real name = LOAD(CARRY(nth));
#define RESUME_SUMS(i, at, nth)            \
    real below##i = LOAD(CARRY(nth));      \
    real own##i = LOAD(CARRY((nth) + 1));  \
    real c##i = LOAD(CARRY((nth) + 2));
#define SUSPEND(name, nth) STORE(name, CARRY(nth));
#define SUSPEND_SUMS(i, nth)             \
    STORE(below##i, CARRY(nth));         \
    STORE(own##i, CARRY((nth) + 1));     \
    STORE(c##i, CARRY((nth) + 2));

// The cells beside a whole row, as the boundary puts them there.
static inline void pelage_close(local scalar* row, int columns) {
    const int left = pelage_stands_for(-1, columns, -1);
    const int right = pelage_stands_for(columns, columns, -1);
    row[-1] = left < 0 ? 0 : row[left];
    row[columns] = right < 0 ? 0 : row[right];
}

// A level writes rows that lie one lower than those it reads.
#define MIDDLE (r - 1)
#define AT_ROW (base + r - level - 1)

kernel __attribute__((reqd_work_group_size(PELAGE_GROUP, 1, 1))) void pelage_lattice_stream(
    global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate, global scalar* odd_rate,
    global scalar* even_polarity, global scalar* odd_polarity, global scalar* even_mapping, global scalar* odd_mapping,
    global const int* birth, global const int* neighbours, global const scalar* places, global const scalar* fields,
    global const scalar* parameters, const int columns, const int rows, const int pitch, const int vectors,
    const int strip, const uint first, const int steps, const int passes, const uint seed_low, const uint seed_high,
    const int margin
#ifdef PELAGE_TOGETHER
    ,
    volatile global int* flags, const int strips, const int begin, const int everybody
#endif
) {
    local scalar scratch[SCRATCH_SIZE] __attribute__((aligned(128)));
    local scalar carry[CARRY_SIZE] __attribute__((aligned(128)));
    const int lane = (int)get_local_id(0);
    const long plane = (long)pitch * (rows + 1);
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
    //@ parameters
    const int inner = vectors * PELAGE_WIDTH - 2 * margin;
    const int x0 = (int)get_group_id(0) * inner - margin;
    // Nothing of what is cleared here reaches the lattice; it only must be a number.
    for (int i = lane; i < SCRATCH_SIZE; i += PELAGE_GROUP) scratch[i] = 0;
    for (int i = lane; i < CARRY_SIZE; i += PELAGE_GROUP) carry[i] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
#ifdef PELAGE_TOGETHER
    if (strips > 0) atomic_inc(&flags[ARRIVED]);
#endif
    for (int turn = 0;; ++turn) {
        int pass = turn;
        int mine = turn < passes ? (int)get_group_id(1) : -1;
#ifdef PELAGE_TOGETHER
        if (strips > 0) {
            mine = pelage_claim(flags, strips, (int)get_group_id(1), begin + passes, everybody, &pass);
            pass -= begin;
        }
#endif
        if (mine < 0) break;
        const int low = mine * strip;
        const int high = min(low + strip, rows);
        const int blocks = AT_LEAST_ONCE((high - low + 2 * steps + PELAGE_BLOCK - 1) / PELAGE_BLOCK);
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
            const int levels = AT_LEAST_ONCE(min(steps, (block * PELAGE_BLOCK + PELAGE_BLOCK - 1) / 2 + 1));
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
                if (margin == 0) {
                    for (int i = lane; i < (PELAGE_BLOCK + KEPT) * PELAGE_FIELDS; i += PELAGE_GROUP) {
                        pelage_close(SCRATCH(level & 1, -KEPT, 0) + i * SLOT, columns);
                    }
                }
                barrier(CLK_LOCAL_MEM_FENCE);
                //@ shared
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
                        //@ neighbours
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
                    const int from = x0 + margin;
                    const int to = min(from + inner, columns);
                    //@ put
                }
            }
            barrier(CLK_LOCAL_MEM_FENCE);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
#ifdef PELAGE_TOGETHER
        if (strips > 0) pelage_done(flags, mine, begin + pass);
#endif
    }
}
