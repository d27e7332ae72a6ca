// One iteration of the cells at a mesh's vertices: rules, then what comes along the edges, then bounds. A work-item takes
// one cell. Cells lie in an order of their own, in which neighbours are near each other; `ids` tells which is which. The
// neighbours of a cell are taken in ascending id.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/mesh/step.cpp.

#define WHOLE_NEIGHBOURS TO_UINT(neighbours[at])
#define WHOLE_BIRTH TO_UINT(birth[at])
#define WHOLE_AGE ((uint)iteration - WHOLE_BIRTH)
#define WHOLE_ROW 0u
#define WHOLE_COLUMN W(0)
#define WHOLE_LAYER 0u
#define WHOLE_ROWS 0u
#define WHOLE_COLUMNS 0u
#define WHOLE_LAYERS 0u
#define GET_X places[at]
#define GET_Y places[cells + at]
#define GET_Z places[2L * cells + at]

// One value a cell in each plane.
#define PLANE_OF(array, i) ((array) + (long)(i) * cells)

kernel void pelage_mesh_step(global const scalar* old_conc, global scalar* new_conc, global const scalar* old_rate,
                             global scalar* new_rate, global scalar* mapping, global int* neighbours,
                             global const int* birth, global const uint* ids, global const scalar* places,
                             global const uint* offsets, global const uint* indices, global const scalar* weights,
                             global const scalar* parameters, const int cells, const uint iteration,
                             const uint seed_low, const uint seed_high) {
    const long at = (long)get_global_id(0);
    if (at >= cells) return;
    const uint begin = offsets[at];
    const uint end = offsets[at + 1];
    const uint id = ids[at];
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
    //@ parameters
    //@ cell
    //@ look
    {
        //@ rules
        for (uint entry = begin; entry < end; ++entry) {
            const uint there = indices[entry];
            const real share = weights[entry];
            //@ neighbour
        }
        //@ finish
    }
    neighbours[at] = (int)(end - begin);
}
