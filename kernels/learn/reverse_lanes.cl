// The way back through one iteration where many work-items are at hand: one takes a cell, and then one takes a lane of a
// few weights. The bits are those of pelage_learn_reverse. Needs learn/iteration.cl, with PELAGE_TILE the cells of a
// sample.

#define PELAGE_SHARE 4  // chemicals, and hidden values, whose weights a work-item takes
#define PELAGE_SHARES (PELAGE_CHEMICALS / PELAGE_SHARE * (PELAGE_HIDDEN / PELAGE_SHARE))

// acts, slopes: [sample][hidden][cell].
kernel void pelage_learn_reverse_cells(global const scalar* restrict weights, global const scalar* restrict states,
                                       global const scalar* restrict after, global scalar* restrict before,
                                       global scalar* restrict acts, global scalar* restrict slopes) {
    const int n = (int)get_global_id(0) * PELAGE_WIDTH;
    if (n >= PELAGE_BATCH * PELAGE_CELLS) return;
    const int sample = n / PELAGE_CELLS, cell = n % PELAGE_CELLS;
    const int begin = sample * PELAGE_SAMPLE, hidden = sample * (PELAGE_HIDDEN * PELAGE_CELLS);
    pelage_reverse_cells(weights, states + begin, after + begin, before + begin, acts + hidden, slopes + hidden, cell, cell);
}

// Adds the products of a few rows of a and of b, in those cells of a run that are a lane's, to partial sums, those of one
// row of a being `across` weights apart.
PELAGE_LEARN void pelage_add_lane(global const scalar* restrict a, global const scalar* restrict b, int begin, int end,
                               global scalar* restrict sums, int across) {
    scalar parts[PELAGE_SHARE][PELAGE_SHARE];
#pragma unroll
    for (int n = 0; n < PELAGE_SHARE; ++n) {
#pragma unroll
        for (int m = 0; m < PELAGE_SHARE; ++m) parts[n][m] = sums[(n * across + m) * PELAGE_LANES];
    }
    for (int cell = begin; cell < end; cell += PELAGE_LANES) {
        scalar others[PELAGE_SHARE];
#pragma unroll
        for (int m = 0; m < PELAGE_SHARE; ++m) others[m] = b[m * PELAGE_CELLS + cell];
#pragma unroll
        for (int n = 0; n < PELAGE_SHARE; ++n) {
            const scalar own = a[n * PELAGE_CELLS + cell];
#pragma unroll
            for (int m = 0; m < PELAGE_SHARE; ++m) parts[n][m] = fma(own, others[m], parts[n][m]);
        }
    }
#pragma unroll
    for (int n = 0; n < PELAGE_SHARE; ++n) {
#pragma unroll
        for (int m = 0; m < PELAGE_SHARE; ++m) sums[(n * across + m) * PELAGE_LANES] = parts[n][m];
    }
}

// A work-item takes a lane of a share of the weights in one run of cells. sums: [sample][run][weight][lane].
kernel void pelage_learn_add_lanes(global const scalar* restrict states, global const scalar* restrict after,
                                   global const scalar* restrict acts, global const scalar* restrict slopes,
                                   global scalar* restrict sums) {
    const int item = (int)get_global_id(0);
    const int lane = item % PELAGE_LANES, share = item / PELAGE_LANES % PELAGE_SHARES;
    const int run = item / (PELAGE_LANES * PELAGE_SHARES);
    if (run >= PELAGE_BATCH * PELAGE_RUNS) return;
    const int sample = run / PELAGE_RUNS;
    const int begin = run % PELAGE_RUNS * PELAGE_RUN_CELLS + lane;
    const int end = min(run % PELAGE_RUNS * PELAGE_RUN_CELLS + PELAGE_RUN_CELLS, PELAGE_CELLS);
    const int i = share / (PELAGE_HIDDEN / PELAGE_SHARE) * PELAGE_SHARE;
    const int h = share % (PELAGE_HIDDEN / PELAGE_SHARE) * PELAGE_SHARE;
    global const scalar* x = states + sample * PELAGE_SAMPLE + i * PELAGE_CELLS;
    global const scalar* dy = after + sample * PELAGE_SAMPLE + i * PELAGE_CELLS;
    global const scalar* act = acts + (sample * PELAGE_HIDDEN + h) * PELAGE_CELLS;
    global const scalar* dz = slopes + (sample * PELAGE_HIDDEN + h) * PELAGE_CELLS;
    global scalar* own = sums + (long)run * (PELAGE_WEIGHTS * PELAGE_LANES) + lane;
    global scalar* first = own + (i * PELAGE_HIDDEN + h) * PELAGE_LANES;
    global scalar* second = own + (PELAGE_SECOND + h * PELAGE_CHEMICALS + i) * PELAGE_LANES;
    pelage_add_lane(x, dz, begin, end, first, PELAGE_HIDDEN);
    pelage_add_lane(act, dy, begin, end, second, PELAGE_CHEMICALS);
    if (i != 0) return;
    for (int k = 0; k < PELAGE_SHARE; ++k) {
        global scalar* bias = own + (PELAGE_BIAS + h + k) * PELAGE_LANES;
        scalar sum = *bias;
        for (int cell = begin; cell < end; cell += PELAGE_LANES) sum = sum + dz[k * PELAGE_CELLS + cell];
        *bias = sum;
    }
}
