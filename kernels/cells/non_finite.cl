// Looks for concentrations that are no longer numbers.

__kernel void pelage_cells_non_finite(__global const scalar* restrict conc, int n, int pitch, int chemicals,
                                 __global int* restrict found) {
    const int i = (int)get_global_id(0);
    if (i >= n) return;
    for (int plane = 0; plane < chemicals; ++plane) {
        if (!IS_FINITE(conc[(long)plane * pitch + i])) found[0] = 1;
    }
}
