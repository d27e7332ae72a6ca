// Mirror pairs: both cells take the mean of concentrations and rates.

static inline void pelage_cells_even(int a, int b, int pitch, int chemicals, __global scalar* conc,
                                     __global scalar* rate) {
    for (int plane = 0; plane < chemicals; ++plane) {
        const long base = (long)plane * pitch;
        const scalar mean_conc = (conc[base + a] + conc[base + b]) / 2;
        conc[base + a] = mean_conc;
        conc[base + b] = mean_conc;
        const scalar mean_rate = (rate[base + a] + rate[base + b]) / 2;
        rate[base + a] = mean_rate;
        rate[base + b] = mean_rate;
    }
}

// Pairs first .. first + count - 1 have no cell in common. Does nothing after a step that was skipped.
__kernel void pelage_cells_mirror(__global const int2* restrict pairs, int first, int count, int pitch, int chemicals,
                                  __global const int* restrict place_of,
                                  __global const struct pelage_progress* restrict progress, int step,
                                  __global scalar* restrict conc, __global scalar* restrict rate) {
    const int i = (int)get_global_id(0);
    if (i >= count || progress[step].skipped) return;
    pelage_cells_even(place_of[pairs[first + i].x], place_of[pairs[first + i].y], pitch, chemicals, conc, rate);
}
