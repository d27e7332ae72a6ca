// Several iterations of a lattice while a tile of it lies in local memory: for devices with many small processors.
// A work-group takes a tile and a margin of `steps` cells around it into scratch, and takes `steps` levels there, each
// from one half of the scratch to the other. With each level the outermost cells of the margin lose their worth; cells
// beyond the edge are the ones that the boundary puts there (a mirrored or wrapped cell evolves exactly like its
// original, random draws included). A work-item goes up a stretch of rows, so that sums of rows are used twice more.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/lattice/emit_fused.hpp.
//   PELAGE_TALL      most rows of a tile, margins included
//   PELAGE_VECTORS   most vectors across, margins included

#define STRETCH 8
#define SLOT (PELAGE_VECTORS * PELAGE_WIDTH)
#define SCRATCH_SIZE (2 * PELAGE_TALL * PELAGE_FIELDS * SLOT + 32)
#define SCRATCH(parity, r, field) (scratch + 16 + (((parity) * PELAGE_TALL + (r)) * PELAGE_FIELDS + (field)) * SLOT)

// What a stretch begins with: the sums of the rows below and here and the cells here.
#define OF_ROW(r, at) (SCRATCH(level & 1, r, at) + c * PELAGE_WIDTH)
#define RESUME(name, at, nth) real name = LOAD(OF_ROW(bottom, at));
#define SUM_OF_ROW(r, at, middle) ROW_SUM(LOAD(OF_ROW(r, at) - 1), middle, LOAD(OF_ROW(r, at) + 1))
#define RESUME_SUMS(i, at, nth)                               \
    real c##i = LOAD(OF_ROW(bottom - 1, at));                 \
    real below##i = OUTER(SUM_OF_ROW(bottom - 1, at, c##i), c##i); \
    c##i = LOAD(OF_ROW(bottom, at));                          \
    real own##i = SUM_OF_ROW(bottom, at, c##i);

#define MIDDLE r
#define AT_ROW (base + r)

kernel __attribute__((reqd_work_group_size(PELAGE_GROUP, 1, 1))) void pelage_lattice_tile(
    global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate, global scalar* odd_rate,
    global scalar* even_polarity, global scalar* odd_polarity, global scalar* even_mapping, global scalar* odd_mapping,
    global const int* birth, global const int* neighbours, global const scalar* places,
    global const scalar* parameters, const int columns, const int rows, const int pitch, const int vectors,
    const int strip, const uint first, const int steps, const int passes, const uint seed_low, const uint seed_high) {
    local scalar scratch[SCRATCH_SIZE] __attribute__((aligned(128)));
    const int lane = (int)get_local_id(0);
    const long plane = (long)pitch * (rows + 1);
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    //@ parameters
    const int pass = 0;
    //@ planes
    const int wide = vectors * PELAGE_WIDTH;
    const int inner = wide - 2 * steps;
    const int x0 = (int)get_group_id(0) * inner - steps;
    const int low = (int)get_group_id(1) * strip;
    const int high = min(low + strip, rows);
    const int base = low - steps;
    const int tall = high - low + 2 * steps;
#if PELAGE_WIDTH > 1
    // Vectors reach past their rows; nothing of what is cleared here reaches the lattice, it only must be a number.
    for (int i = lane; i < SCRATCH_SIZE; i += PELAGE_GROUP) scratch[i] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
#endif
    for (int i = lane; i < tall * vectors; i += PELAGE_GROUP) {
        const int r = i / vectors;
        const int c = i - r * vectors;
        const int x = x0 + c * PELAGE_WIDTH;
        const long there = (long)pelage_stands_for(min(base + r, rows + steps - 1), rows, -1) * pitch;
        //@ fetch
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int level = 0; level < steps; ++level) {
        const int step = level;
        const uint iteration = first + (uint)step;
        // What is still of worth: all but the outermost level + 1 rows and columns, whole vectors of them.
        const int from = (level + 1) / PELAGE_WIDTH;
        const int across = (wide - level - 2) / PELAGE_WIDTH + 1 - from;
        const int up_to = tall - level - 1;
        const int stretches = (up_to - level - 1 + STRETCH - 1) / STRETCH;
        for (int i = lane; i < across * stretches; i += PELAGE_GROUP) {
            const int stretch = i / across;
            const int c = from + i - stretch * across;
            const int x = x0 + c * PELAGE_WIDTH;
            const int bottom = level + 1 + stretch * STRETCH;
            const int top = min(bottom + STRETCH, up_to);
            //@ resume
            for (int r = bottom; r < top; ++r) {
                local const scalar* const above = SCRATCH(level & 1, r + 1, 0) + c * PELAGE_WIDTH;
                local scalar* const result = SCRATCH(~level & 1, r, 0) + c * PELAGE_WIDTH;
                //@ row
                //@ cell
                //@ rules
                //@ diffusion
                //@ neighbours
                //@ replace
                //@ finish
            }
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    for (int i = lane; i < (high - low) * vectors; i += PELAGE_GROUP) {
        const int r = steps + i / vectors;
        const int c = i - (r - steps) * vectors;
        const int x = x0 + c * PELAGE_WIDTH;
        const long there = (long)(base + r) * pitch;
        const int from = x0 + steps;
        const int to = min(from + inner, columns);
        //@ put
    }
}
