// One iteration of a lattice, or several where a single work-item does all of it.
// A work-item takes PELAGE_WIDTH columns side by side and `band` rows, and strides on by the global size. Everything is
// read from the old planes. `steps` may exceed 1 only where the global size is 1: then nobody else reads what is
// written. Lines that begin with //@ are filled in for each experiment, see host/opencl/emit_lattice.hpp.
//   PELAGE_VISITS    some chemical diffuses neighbour by neighbour, or some gradient is wanted

#define GET_NEIGHBOURS TO_REAL(LOAD(neighbours + at))
#define GET_AGE TO_REAL((uintv)(iteration)-TO_UINT(LOAD(birth + at)))
#define GET_BIRTH TO_REAL(LOAD(birth + at))
#define GET_X LOAD(places + x)
#define GET_Y R(places[pitch + row])
#define GET_ROW R((scalar)row)
#define GET_COLUMN TO_REAL((uintv)((uint)x) + LANES)
#define GET_ROWS R((scalar)rows)
#define GET_COLUMNS R((scalar)columns)

// Elements past the last column stay 0.
#define KEEP(v, p) STORE(SELECT(held, v, R(0)), p)

// Planes begin 16 elements into their buffer, each with a row of zeros.
#define PLANE(buffer, nth) ((buffer) + 16 + (nth) * plane + pitch)

#define SWAP(a, b)                      \
    {                                   \
        global scalar* const kept = a;  \
        a = b;                          \
        b = kept;                       \
    }

kernel void pelage_lattice_step(global scalar* old_conc, global scalar* new_conc, global scalar* old_rate,
                                global scalar* new_rate, global scalar* old_polarity, global scalar* new_polarity,
                                global scalar* mapping, global int* birth, global int* neighbours,
                                global const scalar* places, global const scalar* parameters, const int columns,
                                const int rows, const int pitch, const int band, const uint first, const uint steps,
                                const uint seed_low, const uint seed_high) {
    const long plane = (long)pitch * (rows + 1);
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    //@ parameters
    for (uint step = 0; step < steps; ++step) {
        const uint iteration = first + step;
        //@ planes
        for (int x = (int)get_global_id(0) * PELAGE_WIDTH; x < columns; x += (int)get_global_size(0) * PELAGE_WIDTH) {
            const mask held = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));
            const int low = (int)get_global_id(1) * band;
            const int high = min(low + band, rows);
            //@ start
            for (int row = low; row < high; ++row) {
                const long at = (long)row * pitch + x;
                const uintv id = (uintv)((uint)row * (uint)columns + (uint)x) + LANES;
                //@ cell
                //@ rules
                //@ diffusion
#ifdef PELAGE_VISITS
                for (int k = 0; k < 3; ++k) {
                    const int up = pelage_up(k, row, rows);
                    const int beyond = row + up < 0 || row + up >= rows;
#ifdef PELAGE_NO_FLUX
                    if (beyond) continue;
#endif
                    const long there = ROW_AT(row + up);
                    for (int side = -1; side <= 1; ++side) {
#ifdef PELAGE_FIVE_POINT
                        if ((up == 0) == (side == 0)) continue;
#else
                        if (up == 0 && side == 0) continue;
#endif
                        const mask inside = pelage_inside(x, columns, side, beyond);
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
        }
        //@ swap
    }
}
