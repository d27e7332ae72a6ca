// Division: children get ids n, n + 1, ... in order of (parent's id, rule), whatever the physical order of cells.
// divides[id] holds one bit for each `divide` rule that the cell obeyed in the last step.

__kernel void pelage_cells_count_children(__global const uint* restrict divides, int n, int chunks,
                                          __global int* restrict sums) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    int sum = 0;
    for (int id = pelage_chunk_begin(n, chunk, chunks); id < end; ++id) sum += (int)popcount(divides[id]);
    sums[chunk] = sum;
}

// Sine and cosine of an angle in degrees by a fixed polynomial about the nearest multiple of a quarter turn: the
// device's own would differ from the host's. (cosine, sine).
static inline void pelage_direction(scalar degrees, scalar* cosine, scalar* sine) {
    const scalar half_turns = degrees / 180;
    const scalar t = half_turns - 2 * rint(half_turns * (scalar)0.5);  // -1 .. 1
    const scalar s = fabs(t);
    const scalar quarters = s * 2 + (scalar)0.5;
    const int q = quarters < 1 ? 0 : quarters < 2 ? 1 : 2;
    const scalar r = s - (scalar)0.5 * (scalar)q;
    const scalar z = r * r;
    const scalar sn = r * (3.14159265f + z * (-5.16771278f + z * (2.55016404f + z * (-0.59926453f + z * 0.08214589f))));
    const scalar cs =
        1 + z * (-4.93480220f + z * (4.05871213f + z * (-1.33526277f + z * (0.23533063f + z * -0.02580689f))));
    *cosine = q == 0 ? cs : q == 1 ? -sn : -cs;
    *sine = q == 0 ? sn : q == 1 ? cs : -sn;
    if (t < 0) *sine = -*sine;
}

// Children of cells begin .. end - 1, the first of them with id `child`. A child copies its parent's state before the
// step, sits one radius away and looks away from it. The order of cells is loosened: children lie behind all others,
// each at the place that equals its id.
static inline void pelage_cells_bear(int begin, int end, int child, __global uint* divides,
                                     __global const scalar* degrees, int pitch, int chemicals, int mappings,
                                     int born, __global int* place_of, PELAGE_CELL_ARRAYS(const, _old, ),
                                     PELAGE_CELL_ARRAYS(, _new, )) {
    for (int id = begin; id < end; ++id) {
        uint rules = divides[id];
        if (rules == 0) continue;
        divides[id] = 0;
        const int parent = place_of[id];
        for (int rule = 0; rules != 0; ++rule, rules >>= 1) {
            if ((rules & 1u) == 0) continue;
            scalar cosine, sine;
            pelage_direction(degrees[(long)rule * pitch + id], &cosine, &sine);
            scalar x = polarity_old[parent];
            scalar y = polarity_old[pitch + parent];
            if (x == 0 && y == 0) {
                x = 1;
            } else {
                const scalar norm = sqrt(x * x + y * y);
                x = x / norm;
                y = y / norm;
            }
            const scalar away_x = x * cosine - y * sine;
            const scalar away_y = x * sine + y * cosine;
            position_new[child] = position_old[parent] + away_x;
            position_new[pitch + child] = position_old[pitch + parent] + away_y;
            polarity_new[child] = away_x;
            polarity_new[pitch + child] = away_y;
            for (int plane = 0; plane < chemicals; ++plane) {
                const long base = (long)plane * pitch;
                conc_new[base + child] = conc_old[base + parent];
                rate_new[base + child] = rate_old[base + parent];
            }
            for (int plane = 0; plane < mappings; ++plane) {
                mapping_new[(long)plane * pitch + child] = mapping_old[(long)plane * pitch + parent];
            }
            neighbours_new[child] = 0;
            id_new[child] = child;
            birth_new[child] = born;
            fixed_new[child] = 0;
            place_of[child] = child;
            ++child;
        }
    }
}

__kernel void pelage_cells_append_children(__global uint* restrict divides, __global const scalar* restrict degrees,
                                           int n, int pitch, int chunks, __global const int* restrict sums,
                                           int chemicals, int mappings, int born,
                                           __global int* restrict place_of, PELAGE_CELL_ARRAYS(const, _old, ),
                                           PELAGE_CELL_ARRAYS(, _new, )) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    pelage_cells_bear(pelage_chunk_begin(n, chunk, chunks), pelage_chunk_begin(n, chunk + 1, chunks),
                      n + pelage_sum_before(sums, chunk), divides, degrees, pitch, chemicals, mappings, born, place_of,
                      PELAGE_THESE(_old), PELAGE_THESE(_new));
}
