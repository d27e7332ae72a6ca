// One iteration of PELAGE_WIDTH cells at a mesh's vertices: rules, then what comes along the edges, then bounds. Cells lie
// in an order of their own, in which neighbours are near each other; `ids` tells which is which. Planes are `pitch` long,
// a multiple of 16: cells past the last are computed like the others, and nobody looks at them.
// The neighbours of a cell are taken in ascending id. Blocks of 16 cells interleave their lists: entry k of cell c lies at
// (rows[c / 16] + k) * 16 + c % 16. A list shorter than the longest of its block goes on with the cell itself.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/mesh/step.cpp.

#define WHOLE_NEIGHBOURS TO_UINT(LOAD(neighbours + first))
#define WHOLE_BIRTH TO_UINT(LOAD(birth + first))
#define WHOLE_AGE ((uintv)(iteration)-WHOLE_BIRTH)
#define WHOLE_ROW 0u
#define WHOLE_COLUMN W(0)
#define WHOLE_LAYER 0u
#define WHOLE_ROWS 0u
#define WHOLE_COLUMNS 0u
#define WHOLE_LAYERS 0u
#define GET_X LOAD(places + first)
#define GET_Y LOAD(places + pitch + first)
#define GET_Z LOAD(places + 2L * pitch + first)

// One value a cell in each plane.
#define PLANE_OF(array, i) ((array) + (long)(i) * pitch)

// Which lanes have a k-th neighbour.
#if PELAGE_WIDTH == 1
#define LISTED(k) ALL_TRUE
#else
#define LISTED(k) TO_MASK((intv)(k) < length)
#endif

kernel void pelage_mesh_step(global const scalar* old_conc, global scalar* new_conc, global const scalar* old_rate,
                             global scalar* new_rate, global scalar* mapping, global const int* neighbours,
                             global const int* birth, global const uint* ids, global const scalar* places,
                             global const uint* rows, global const int* lengths, global const uint* indices,
                             global const scalar* weights, global const scalar* parameters, const int pitch,
                             const uint iteration, const uint seed_low, const uint seed_high) {
    const int first = (int)get_global_id(0) * PELAGE_WIDTH;
    if (first >= pitch) return;
    const uintv id = LOAD(ids + first);
    const intv length = LOAD(lengths + first);
    const int block = first >> 4;
#if PELAGE_WIDTH == 1
    const int longest = length;
#else
    const int longest = (int)(rows[block + 1] - rows[block]);
#endif
    const long list = (long)rows[block] * 16 + (first & 15);  // not / and %: Oclgrind 21.10 lacks what clang makes of them
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
    //@ parameters
    //@ cell
    //@ look
    {
        //@ rules
        for (int k = 0; k < longest; ++k) {
            const mask listed = LISTED(k);
            const uintv there = LOAD(indices + list + k * 16L);
            const real share = LOAD(weights + list + k * 16L);
            //@ neighbour
        }
        //@ finish
    }
}
