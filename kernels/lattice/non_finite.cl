// Finds the first cell of a plane that holds a NaN or an infinity.

// found[plane] holds 0xffffffff before, the smallest id after.
kernel void pelage_lattice_non_finite(global const scalar* restrict conc, global uint* restrict found,
                                      const int columns, const int rows, const int pitch, const int planes) {
    for (int plane = 0; plane < planes; ++plane) {
        global const scalar* const from = conc + 16 + (long)plane * pitch * (rows + 1) + pitch;
        for (int row = (int)get_global_id(0); row < rows; row += (int)get_global_size(0)) {
            for (int x = (int)get_global_id(1); x < columns; x += (int)get_global_size(1)) {
                if (IS_FINITE(from[(long)row * pitch + x])) continue;
                atomic_min(&found[plane], (uint)row * (uint)columns + (uint)x);
                break;
            }
        }
    }
}
