// One iteration of a lattice, or several a launch.
// A work-item takes PELAGE_WIDTH columns side by side and `band` rows, and strides on by the global size. Everything is
// read from the planes of one parity and written to those of the other. Without PELAGE_TOGETHER `steps` may exceed 1
// only where the global size is 1: then nobody else reads what is written. With it work-groups of one work-item share
// strips of `band` rows and wait for each other, see lattice/together.cl.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/lattice/emit_lattice.hpp.
//   PELAGE_TOGETHER    see above
//   PELAGE_MEANS       rates between neighbours are known, see lattice/means.cl
//   PELAGE_BATCH       a launch is of several lattices, see host/opencl/lattice/emit_batch.hpp; then `steps` may exceed 1 only
//                      where one work-item has a lattice to itself

#define WHOLE_NEIGHBOURS TO_UINT(LOAD(neighbours + at))
#define WHOLE_AGE ((uintv)(iteration)-TO_UINT(LOAD(birth + at)))
#define WHOLE_BIRTH TO_UINT(LOAD(birth + at))
#define WHOLE_ROW ((uint)row)
#define WHOLE_COLUMN ((uintv)((uint)x) + LANES)
#define GET_X LOAD(places + x)
#define GET_Y R(places[pitch + row])

// The row `up` of this one, and which neighbours lie inside.
#if PELAGE_REACH > 1
#define THERE(up) ROW_AROUND(row + (up))
#else
#define THERE(up) ROW_AT(row + (up))
#endif
#define AROUND(cells, side, up) pelage_around((cells) + ROW_AROUND(row + (up)), x, columns, side)
#define INSIDE(side, beyond) pelage_inside(x, columns, side, beyond)

// Elements past the last column stay 0.
#define KEEP(v, p) STORE(SELECT(held, v, R(0)), p)

kernel void pelage_lattice_step(global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate,
                                global scalar* odd_rate, global scalar* even_polarity, global scalar* odd_polarity,
                                global scalar* mapping, global int* birth, global int* neighbours,
                                global const scalar* places, global const scalar* fields, global const scalar* parameters, const int columns,
                                const int rows, const int pitch, const int band, const uint first, const uint steps,
                                uint seed_low, uint seed_high
#ifdef PELAGE_TOGETHER
                                ,
                                volatile global int* flags, const int strips, const int begin, const int everybody
#endif
#ifdef PELAGE_MEANS
                                ,
                                global const scalar* means
#endif
#ifdef PELAGE_BATCH
                                ,
                                global const int* members
#endif
) {
    const long plane = (long)pitch * (rows + 1);
    //@ batch
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
    //@ parameters
#ifdef PELAGE_TOGETHER
    atomic_inc(&flags[ARRIVED]);
    const int end = begin + (int)steps;
    for (;;) {
        int level = 0;
        const int strip = pelage_claim(flags, strips, (int)get_group_id(1), end, everybody, &level);
        if (strip < 0) return;
        const uint step = (uint)(level - begin);
        const int low = strip * band;
#else
    for (uint step = 0; step < steps; ++step) {
        const int low = (int)get_global_id(1) * band;
#endif
        const uint iteration = first + step;
        const int high = min(low + band, rows);
        global scalar* const old_conc = step % 2 == 0 ? even_conc : odd_conc;
        global scalar* const new_conc = step % 2 == 0 ? odd_conc : even_conc;
        global scalar* const old_rate = step % 2 == 0 ? even_rate : odd_rate;
        global scalar* const new_rate = step % 2 == 0 ? odd_rate : even_rate;
        global scalar* const old_polarity = step % 2 == 0 ? even_polarity : odd_polarity;
        global scalar* const new_polarity = step % 2 == 0 ? odd_polarity : even_polarity;
        //@ planes
        //@ shared
        for (int x = (int)get_global_id(0) * PELAGE_WIDTH; x < columns; x += (int)get_global_size(0) * PELAGE_WIDTH) {
            const mask held = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));
            //@ start
            for (int row = low; row < high; ++row) {
                const long at = (long)row * pitch + x;
                const uintv id = (uintv)((uint)row * (uint)columns + (uint)x) + LANES;
                //@ cell
                //@ rules
                //@ diffusion
                //@ neighbours
                //@ replace
                //@ finish
            }
        }
#ifdef PELAGE_TOGETHER
        pelage_done(flags, strip, level);
#endif
    }
}
