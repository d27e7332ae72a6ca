// The rates between neighbours of a lattice where nothing changes them: so the harmonic mean, a division for each of eight
// neighbours, is taken once for each pair and not in every iteration. A mean and what is felt along a direction are the
// same seen from both sides, to the bit. Of a cell four means are kept: with its neighbours to the right, and in the row
// above on the left, in the middle and on the right; the other four are its neighbours'.
// Lines that begin with //@ are filled in, see host/opencl/lattice/means.hpp.

kernel void pelage_lattice_means(global const scalar* rates, global const scalar* polarity, global scalar* means,
                                 const int columns, const int rows, const int pitch) {
    const long plane = (long)pitch * (rows + 1);
    for (int row = (int)get_global_id(1); row < rows; row += (int)get_global_size(1)) {
        for (int x = (int)get_global_id(0) * PELAGE_WIDTH; x < columns; x += (int)get_global_size(0) * PELAGE_WIDTH) {
            const long at = (long)row * pitch + x;
            const mask held = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));
            //@ planes
            for (int k = 0; k < 4; ++k) {
                const int up = k > 0;
                const int side = k == 0 ? 1 : k - 2;
                const long there = ROW_AT(row + up);
                const real dx = R((scalar)(2 * side));
                const real dy = R((scalar)(2 * up));
                const int diagonal = up != 0 && side != 0;
                //@ means
            }
        }
    }
}
