// Several iterations of a lattice while a tile of it lies in local memory: for devices with many small processors.
// A work-group takes a tile and a margin of `steps` cells around it into scratch, and takes `steps` levels there, each
// from one half of the scratch to the other. With each level the outermost cells of the margin lose their worth; cells
// beyond the edge are the ones that the boundary puts there (a mirrored or wrapped cell evolves exactly like its
// original, random draws included). A work-item goes up a stretch of rows, so that sums of rows are used twice more;
// stretches are as low as the work-items are many.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/lattice/emit_fused.hpp.
//   PELAGE_TALL      most rows of a tile, margins included
//   PELAGE_VECTORS   most vectors across, margins included
//   PELAGE_BATCH     a launch is of several lattices, see host/opencl/lattice/emit_batch.hpp

#define SLOT (PELAGE_VECTORS * PELAGE_WIDTH)
#define ROW_OF_TILE (PELAGE_FIELDS * SLOT)
#define SCRATCH_SIZE (2 * PELAGE_TALL * ROW_OF_TILE + 32)
#define SCRATCH(parity, r, field) (scratch + 16 + ((parity) * PELAGE_TALL + (r)) * ROW_OF_TILE + (field) * SLOT)

// What a stretch begins with: the sums of the rows below and here and the cells here.
#define OF_ROW(r, at) (SCRATCH(level & 1, r, at) + c * PELAGE_WIDTH)
#define RESUME(name, at, nth) real name = LOAD(OF_ROW(bottom, at));
#define SUM_OF_ROW(r, at, middle) ROW_SUM(LOAD(OF_ROW(r, at) - 1), middle, LOAD(OF_ROW(r, at) + 1))
#define RESUME_SUMS(i, at, nth)                               \
    real c##i = LOAD(OF_ROW(bottom - 1, at));                 \
    real below##i = OUTER(SUM_OF_ROW(bottom - 1, at, c##i), c##i); \
    c##i = LOAD(OF_ROW(bottom, at));                          \
    real own##i = SUM_OF_ROW(bottom, at, c##i);

// From the vector (r, c) of a tile to the one that lies a group's size further on.
#define GO_ON(r, c) c += along, r += down, r += c >= vectors, c -= c >= vectors ? vectors : 0

#define MIDDLE r
#define AT_ROW (base + r)

kernel __attribute__((reqd_work_group_size(PELAGE_GROUP, 1, 1))) void pelage_lattice_tile(
    global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate, global scalar* odd_rate,
    global scalar* even_polarity, global scalar* odd_polarity, global scalar* even_mapping, global scalar* odd_mapping,
    global const int* birth, global const int* neighbours, global const scalar* places, global const scalar* fields,
    global const scalar* parameters, const int columns, const int rows, const int pitch, const int vectors,
    const int strip, const uint first, const int steps, const int passes, uint seed_low, uint seed_high
#ifdef PELAGE_BATCH
    ,
    global const int* members
#endif
) {
    local scalar scratch[SCRATCH_SIZE] __attribute__((aligned(128)));
    const int lane = (int)get_local_id(0);
    const long plane = (long)pitch * (rows + 1);
    //@ batch
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
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
    const int down = PELAGE_GROUP / vectors;
    const int along = PELAGE_GROUP - down * vectors;
    const int first_row = lane / vectors;
    const int first_column = lane - first_row * vectors;
    const int all_rows_there = base >= 0 && base + tall <= rows;
#if PELAGE_WIDTH > 1
    // Vectors reach past their rows; nothing of what is cleared here reaches the lattice, it only must be a number.
    for (int i = lane; i < SCRATCH_SIZE; i += PELAGE_GROUP) scratch[i] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
#endif
    for (int r = first_row, c = first_column; r < tall; GO_ON(r, c)) {
        const int x = x0 + c * PELAGE_WIDTH;
        const int row = all_rows_there ? base + r : pelage_stands_for(min(base + r, rows + steps - 1), rows, -1);
        const long there = (long)row * pitch;
        //@ fetch
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int level = 0; level < AT_LEAST_ONCE(steps); ++level) {
        const int step = level;
        const uint iteration = first + (uint)step;
        //@ shared
        // What is still of worth: all but the outermost level + 1 rows and columns, whole vectors of them.
        const int from = (level + 1) / PELAGE_WIDTH;
        const int across = (wide - level - 2) / PELAGE_WIDTH + 1 - from;
        const int up_to = tall - level - 1;
        const int height = up_to - level - 1;
        const int wanted = clamp(PELAGE_GROUP / across, 1, height);
        const int stretch = (height + wanted - 1) / wanted;
        const int stretches = (height + stretch - 1) / stretch;
        for (int i = lane; i < across * stretches; i += PELAGE_GROUP) {
            const int nth = i / across;
            const int c = from + i - nth * across;
            const int x = x0 + c * PELAGE_WIDTH;
            const int bottom = level + 1 + nth * stretch;
            const int top = min(bottom + stretch, up_to);
            //@ resume
            local const scalar* above = SCRATCH(level & 1, bottom + 1, 0) + c * PELAGE_WIDTH;
            local scalar* result = SCRATCH(~level & 1, bottom, 0) + c * PELAGE_WIDTH;
            for (int r = bottom; r < top; ++r, above += ROW_OF_TILE, result += ROW_OF_TILE) {
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
    for (int r = steps + first_row, c = first_column; r < steps + high - low; GO_ON(r, c)) {
        const int x = x0 + c * PELAGE_WIDTH;
        const long there = (long)(base + r) * pitch;
        const int from = x0 + steps;
        const int to = min(from + inner, columns);
        //@ put
    }
}
