// One iteration of free cells a launch, PELAGE_WIDTH cells a work-item.

// progress[step - 1] is that of the step before; progress[0] belongs to the host. A step whose lists cannot be relied
// on any more, or were cut off, does nothing, and neither do those after it.
__kernel void pelage_cells_step(int n, int pitch, PELAGE_CELLS(const, _old), PELAGE_CELLS(, _new),
                                __global const scalar* restrict built, __global const int* restrict lengths,
                                __global const int* restrict lists, int capacity, __global const int* restrict longest,
                                scalar half_width, scalar half_height, __global uint* restrict divides,
                                __global scalar* restrict degrees, scalar longest_way,
                                __global const scalar* parameters,
                                __global struct pelage_progress* restrict progress, int step, uint iteration) {
    const int first = (int)get_global_id(0) * PELAGE_WIDTH;
    if (first >= n) return;
    __global const struct pelage_progress* before = progress + step - 1;
    if (before->moved || before->children > 0 || before->skipped || longest[0] > capacity) {
        if (first == 0) progress[step].skipped = 1;
        return;
    }
    mask strayed;
    const int children = pelage_cells_advance(first, n, pitch, PELAGE_THESE(_old), PELAGE_THESE(_new), built, lengths,
                                              lists, capacity, half_width, half_height, divides, degrees, longest_way,
                                              parameters, iteration, &strayed);
    if (ANY(strayed)) progress[step].moved = 1;
    if (children > 0) atomic_add(&progress[step].children, children);
}
