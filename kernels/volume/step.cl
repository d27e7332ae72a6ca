// One iteration of a volume, or several in one pass over memory.
// A work-item takes PELAGE_WIDTH columns side by side, a strip of rows and `depth` layers. Everything is read from the
// planes of one parity and written to those of the other.
//
// Several `steps` go through the layers in a wave: step s works on the layer s behind that of step 0, so that what a step
// has left is still in the caches when the next one reads it, and what it overwrites nobody reads any more:
//
//      layer     ...  z-2  z-1   z   z+1  ...
//      step 0                    *            reads z-1, z, z+1 of the even planes, writes z of the odd ones
//      step 1              *                  reads z-2, z-1, z of the odd planes, writes z-1 of the even ones
//
// On a torus step s begins at layer s and ends at layer s - 1: there layers + s is layer s.
// Strips that do not wait for each other leave out what hangs on their neighbours: a strip loses one row on either side
// with each step, and a second launch (`between`) does those rows, one more with each step, around the place where two
// strips meet.
// With `steps` above 1 one work-item goes through all layers and all columns of its strip.
// Lines that begin with //@ are filled in for each experiment, see host/opencl/lattice/emit_lattice.hpp.

#define WHOLE_NEIGHBOURS TO_UINT(LOAD(neighbours + at))
#define WHOLE_AGE ((uintv)(iteration)-TO_UINT(LOAD(birth + at)))
#define WHOLE_BIRTH TO_UINT(LOAD(birth + at))
#define WHOLE_ROW ((uint)row)
#define WHOLE_LAYER ((uint)layer)
#define WHOLE_COLUMN ((uintv)((uint)x) + LANES)
#define GET_X LOAD(places + x)
#define GET_Y R(places[pitch + row])
#define GET_Z R((scalar)(2 * layer - layers + 1))

// Elements past the last column stay 0.
#define KEEP(v, p) STORE(SELECT(held, v, R(0)), p)

#ifdef PELAGE_WRAP
#define PELAGE_TORUS 1
#else
#define PELAGE_TORUS 0
#endif

kernel void pelage_volume_step(global scalar* even_conc, global scalar* odd_conc, global scalar* even_rate,
                               global scalar* odd_rate, global scalar* mapping, global int* birth,
                               global int* neighbours, global const scalar* places, global const scalar* fields,
                               global const scalar* parameters, const int columns, const int rows, const int layers,
                               const int pitch, const int strips, const int depth, const uint first, const int steps,
                               const uint seed_low, const uint seed_high, const int between) {
    const long plane = (long)pitch * ((long)rows * layers + 1);
    birth = PLANE(birth, 0);
    neighbours = PLANE(neighbours, 0);
    const real dt = R(parameters[0]);
    const real time_start = R(parameters[1]);
    const uint time_begin = PARAMETER_WORD(2);
    //@ parameters
    const int strip = (int)get_global_id(1);
    const int low = (int)((long)strip * rows / strips);
    const int high = (int)((long)(strip + 1) * rows / strips);
    const int meets_below = (strips > 1) & ((strip > 0) | PELAGE_TORUS);
    const int meets_above = (strips > 1) & ((strip + 1 < strips) | PELAGE_TORUS);
    if (between && !meets_below) return;
    const int front = (int)get_global_id(2) * depth;
    const int back = min(front + depth, layers);
    const int waves = back - front + (steps - 1) * (1 + PELAGE_TORUS);
    for (int wave = 0; wave < waves; ++wave) {
        for (int step = between; step < steps; ++step) {
            const int turned = front + wave - step;
            if (turned < front + PELAGE_TORUS * step || turned >= back + PELAGE_TORUS * step) continue;
            const int layer = turned >= layers ? turned - layers : turned;
            const uint iteration = first + (uint)step;
            global scalar* const old_conc = step % 2 == 0 ? even_conc : odd_conc;
            global scalar* const new_conc = step % 2 == 0 ? odd_conc : even_conc;
            global scalar* const old_rate = step % 2 == 0 ? even_rate : odd_rate;
            global scalar* const new_rate = step % 2 == 0 ? odd_rate : even_rate;
            //@ planes
            //@ shared
            const int from = between ? low - step : low + (meets_below ? step : 0);
            const int to = between ? low + step : high - (meets_above ? step : 0);
            for (int r = from; r < to; ++r) {
                const int row = r < 0 ? r + rows : r >= rows ? r - rows : r;
                const long line = ((long)layer * rows + row) * pitch;
                long lines[9];
                for (int deep = -1; deep <= 1; ++deep) {
                    for (int up = -1; up <= 1; ++up) {
                        LINE(up, deep) = pelage_line(row + up, layer + deep, rows, layers, pitch);
                    }
                }
                for (int x = (int)get_global_id(0) * PELAGE_WIDTH; x < columns;
                     x += (int)get_global_size(0) * PELAGE_WIDTH) {
                    const mask held = TO_MASK((LANES + (uintv)((uint)x)) < (uintv)((uint)columns));
                    const long at = line + x;
                    const uintv id = (uintv)(((uint)layer * (uint)rows + (uint)row) * (uint)columns + (uint)x) + LANES;
                    //@ cell
                    //@ rules
                    //@ diffusion
                    //@ neighbours
                    //@ replace
                    //@ finish
                }
            }
        }
    }
}
