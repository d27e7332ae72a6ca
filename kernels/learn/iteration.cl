// One iteration of the system that learns, and the way back through it; see reference/learn/iteration.hpp. Needs
// common/four.cl, learn/sums.cl and functions/quick_sigmoid.cl.
//   PELAGE_SIDE, PELAGE_BATCH, PELAGE_CHEMICALS, PELAGE_HIDDEN   see LearningShape
//   PELAGE_RUN_CELLS, PELAGE_RUNS   cells of a run, and runs of a sample
//   PELAGE_TILE          cells of a run that are on their way at a time, a multiple of PELAGE_LANES
//   PELAGE_BLOCK         chemicals, and hidden values, whose slopes are summed side by side
// States stand as [sample][chemical][cell], weights as W0 [chemical][hidden], b0 [hidden], W1 [hidden][chemical].

#define PELAGE_CELLS (PELAGE_SIDE * PELAGE_SIDE)
#define PELAGE_SAMPLE (PELAGE_CHEMICALS * PELAGE_CELLS)
#define PELAGE_BIAS (PELAGE_CHEMICALS * PELAGE_HIDDEN)
#define PELAGE_SECOND (PELAGE_BIAS + PELAGE_HIDDEN)
#define PELAGE_WEIGHTS (PELAGE_SECOND + PELAGE_BIAS)
#define PELAGE_HIDDEN_BLOCK 8

#ifdef __clang__
#define PELAGE_LEARN static inline __attribute__((always_inline))
#else
#define PELAGE_LEARN static inline
#endif

// A row's numbers from column x on, where that may lie beyond its ends.
PELAGE_LEARN real pelage_around(global const scalar* row, int x) {
    if (x >= 0 && x + PELAGE_WIDTH <= PELAGE_SIDE) return LOAD(row + x);
    scalar lanes[PELAGE_WIDTH];
    for (int lane = 0; lane < PELAGE_WIDTH; ++lane) {
        const int column = x + lane;
        lanes[lane] = row[column < 0 ? column + PELAGE_SIDE : column >= PELAGE_SIDE ? column - PELAGE_SIDE : column];
    }
    return LOAD(lanes);
}

PELAGE_LEARN real pelage_one_two_one(global const scalar* row, int x) {
    return fma(R(2), LOAD(row + x), pelage_around(row, x - 1) + pelage_around(row, x + 1));
}

// share: a sixteenth of the rate of diffusion.
PELAGE_LEARN real pelage_diffused(global const scalar* plane, int row, int x, real share) {
    global const scalar* own = plane + row * PELAGE_SIDE;
    global const scalar* below = plane + (row == 0 ? PELAGE_SIDE - 1 : row - 1) * PELAGE_SIDE;
    global const scalar* above = plane + (row + 1 == PELAGE_SIDE ? 0 : row + 1) * PELAGE_SIDE;
    const real around = fma(R(2), pelage_one_two_one(own, x), pelage_one_two_one(below, x) + pelage_one_two_one(above, x));
    const real c = LOAD(own + x);
    return fma(share, fma(R(-16), c, around), c);
}

// 1/8, 1/4, 1/2 and 1 for the quarters of the chemicals, divided by 16.
PELAGE_LEARN real pelage_share(int chemical) {
    const int quarter = chemical * 4 / PELAGE_CHEMICALS;
    return R((scalar)(1 << quarter) * (scalar)0.0078125f);
}

// z of a block of hidden values.
PELAGE_LEARN void pelage_ask(global const scalar* restrict weights, const real* x, int h, real* z) {
#pragma unroll
    for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) z[k] = R(weights[PELAGE_BIAS + h + k]);
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* w = weights + i * PELAGE_HIDDEN + h;
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; k += 4) {
            FETCH_FOUR(four, w + k);
            z[k] = fma(x[i], FOURTH(four, w + k, 0), z[k]);
            z[k + 1] = fma(x[i], FOURTH(four, w + k, 1), z[k + 1]);
            z[k + 2] = fma(x[i], FOURTH(four, w + k, 2), z[k + 2]);
            z[k + 3] = fma(x[i], FOURTH(four, w + k, 3), z[k + 3]);
        }
    }
}

// sums[i] += z[k] w[...] over a block of hidden values, of whose weights each has one a chemical (W1).
PELAGE_LEARN void pelage_add_answers(const real* z, global const scalar* restrict w, real* sums) {
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; i += 4) {
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) {
            global const scalar* own = w + k * PELAGE_CHEMICALS + i;
            FETCH_FOUR(four, own);
            sums[i] = fma(z[k], FOURTH(four, own, 0), sums[i]);
            sums[i + 1] = fma(z[k], FOURTH(four, own, 1), sums[i + 1]);
            sums[i + 2] = fma(z[k], FOURTH(four, own, 2), sums[i + 2]);
            sums[i + 3] = fma(z[k], FOURTH(four, own, 3), sums[i + 3]);
        }
    }
}

// The same with the weights of W0, of which each chemical has one a hidden value.
PELAGE_LEARN void pelage_add_questions(const real* z, global const scalar* restrict w, real* sums) {
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        real sum = sums[i];
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; k += 4) {
            global const scalar* own = w + i * PELAGE_HIDDEN + k;
            FETCH_FOUR(four, own);
            sum = fma(z[k], FOURTH(four, own, 0), sum);
            sum = fma(z[k + 1], FOURTH(four, own, 1), sum);
            sum = fma(z[k + 2], FOURTH(four, own, 2), sum);
            sum = fma(z[k + 3], FOURTH(four, own, 3), sum);
        }
        sums[i] = sum;
    }
}

// dz[k] = the slopes along what comes out, dy, times the weights of W1.
PELAGE_LEARN void pelage_ask_back(global const scalar* restrict w, const real* dy, real* dz) {
#pragma unroll
    for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) dz[k] = R(0);
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; i += 4) {
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) {
            global const scalar* own = w + k * PELAGE_CHEMICALS + i;
            FETCH_FOUR(four, own);
            dz[k] = fma(dy[i], FOURTH(four, own, 0), dz[k]);
            dz[k] = fma(dy[i + 1], FOURTH(four, own, 1), dz[k]);
            dz[k] = fma(dy[i + 2], FOURTH(four, own, 2), dz[k]);
            dz[k] = fma(dy[i + 3], FOURTH(four, own, 3), dz[k]);
        }
    }
}

PELAGE_LEARN void pelage_iterate_cells(global const scalar* restrict weights, global const scalar* restrict from,
                                       global scalar* restrict to, int cell) {
    real x[PELAGE_CHEMICALS], y[PELAGE_CHEMICALS];
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* plane = from + i * PELAGE_CELLS;
        x[i] = LOAD(plane + cell);
        y[i] = pelage_diffused(plane, cell / PELAGE_SIDE, cell % PELAGE_SIDE, pelage_share(i));
    }
    for (int h = 0; h < PELAGE_HIDDEN; h += PELAGE_HIDDEN_BLOCK) {
        real z[PELAGE_HIDDEN_BLOCK];
        pelage_ask(weights, x, h, z);
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) z[k] = z[k] * pelage_quick_sigmoid(R(5) * z[k]);
        pelage_add_answers(z, weights + PELAGE_SECOND + h * PELAGE_CHEMICALS, y);
    }
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) STORE(y[i], to + i * PELAGE_CELLS + cell);
}

// `vectors` of them for each work-item.
kernel void pelage_learn_iterate(global const scalar* restrict weights, global const scalar* restrict from,
                                 global scalar* restrict to, const int vectors) {
    for (int n = 0; n < vectors; ++n) {
        const int cell = ((int)get_global_id(0) * vectors + n) * PELAGE_WIDTH;
        if (cell >= PELAGE_BATCH * PELAGE_CELLS) return;
        const int begin = cell / PELAGE_CELLS * PELAGE_SAMPLE;
        pelage_iterate_cells(weights, from + begin, to + begin, cell % PELAGE_CELLS);
    }
}

// Slopes along x of these cells; act and dz of each hidden value are left at `place` of the tile.
PELAGE_LEARN void pelage_reverse_cells(global const scalar* restrict weights, global const scalar* restrict state,
                                       global const scalar* restrict after, global scalar* restrict before,
                                       global scalar* restrict acts, global scalar* restrict slopes, int cell, int place) {
    real x[PELAGE_CHEMICALS], dy[PELAGE_CHEMICALS], dx[PELAGE_CHEMICALS];
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* plane = after + i * PELAGE_CELLS;
        x[i] = LOAD(state + i * PELAGE_CELLS + cell);
        dy[i] = LOAD(plane + cell);
        dx[i] = pelage_diffused(plane, cell / PELAGE_SIDE, cell % PELAGE_SIDE, pelage_share(i));
    }
    for (int h = 0; h < PELAGE_HIDDEN; h += PELAGE_HIDDEN_BLOCK) {
        real z[PELAGE_HIDDEN_BLOCK], dz[PELAGE_HIDDEN_BLOCK];
        pelage_ask(weights, x, h, z);
        pelage_ask_back(weights + PELAGE_SECOND + h * PELAGE_CHEMICALS, dy, dz);
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) {
            const real s = pelage_quick_sigmoid(R(5) * z[k]);
            const real act = z[k] * s;
            dz[k] = dz[k] * fma(R(5) * act, R(1) - s, s);
            STORE(act, acts + (h + k) * PELAGE_TILE + place);
            STORE(dz[k], slopes + (h + k) * PELAGE_TILE + place);
        }
        pelage_add_questions(dz, weights + h, dx);
    }
    PELAGE_UNROLLED for (int i = 0; i < PELAGE_CHEMICALS; ++i) STORE(dx[i], before + i * PELAGE_CELLS + cell);
}

// Adds the products of PELAGE_BLOCK rows of `a` and of `b`, `count` cells long, to the partial sums of weights, those of
// one row of a being `across` weights apart.
PELAGE_LEARN void pelage_add_products(global const scalar* restrict a, int a_pitch, global const scalar* restrict b,
                                      int b_pitch, int count, global scalar* restrict sums, int across) {
    real parts[PELAGE_BLOCK][PELAGE_BLOCK][PELAGE_PARTS];
#pragma unroll
    for (int n = 0; n < PELAGE_BLOCK; ++n) {
#pragma unroll
        for (int m = 0; m < PELAGE_BLOCK; ++m) {
#pragma unroll
            for (int part = 0; part < PELAGE_PARTS; ++part)
                parts[n][m][part] = LOAD(sums + (n * across + m) * PELAGE_LANES + part * PELAGE_WIDTH);
        }
    }
    for (int cell = 0; cell < count; cell += PELAGE_LANES) {
#pragma unroll
        for (int part = 0; part < PELAGE_PARTS; ++part) {
            const int at = cell + part * PELAGE_WIDTH;
            real rows[PELAGE_BLOCK];
#pragma unroll
            for (int m = 0; m < PELAGE_BLOCK; ++m) rows[m] = LOAD(b + m * b_pitch + at);
#pragma unroll
            for (int n = 0; n < PELAGE_BLOCK; ++n) {
                const real own = LOAD(a + n * a_pitch + at);
#pragma unroll
                for (int m = 0; m < PELAGE_BLOCK; ++m) parts[n][m][part] = fma(own, rows[m], parts[n][m][part]);
            }
        }
    }
#pragma unroll
    for (int n = 0; n < PELAGE_BLOCK; ++n) {
#pragma unroll
        for (int m = 0; m < PELAGE_BLOCK; ++m) {
#pragma unroll
            for (int part = 0; part < PELAGE_PARTS; ++part)
                STORE(parts[n][m][part], sums + (n * across + m) * PELAGE_LANES + part * PELAGE_WIDTH);
        }
    }
}

PELAGE_LEARN void pelage_add_biases(global const scalar* restrict slopes, int count, global scalar* restrict sums) {
    for (int part = 0; part < PELAGE_PARTS; ++part) {
        real sum = LOAD(sums + part * PELAGE_WIDTH);
        for (int cell = part * PELAGE_WIDTH; cell < count; cell += PELAGE_LANES) sum = sum + LOAD(slopes + cell);
        STORE(sum, sums + part * PELAGE_WIDTH);
    }
}

// All weights' products of one tile.
PELAGE_LEARN void pelage_add_tile(global const scalar* restrict state, global const scalar* restrict after,
                                  global const scalar* restrict acts, global const scalar* restrict slopes, int count,
                                  global scalar* restrict sums) {
    const int across = PELAGE_HIDDEN / PELAGE_BLOCK;
    for (int block = 0; block < PELAGE_CHEMICALS / PELAGE_BLOCK * across; ++block) {
        const int i = block / across * PELAGE_BLOCK;
        const int h = block % across * PELAGE_BLOCK;
        pelage_add_products(state + i * PELAGE_CELLS, PELAGE_CELLS, slopes + h * PELAGE_TILE, PELAGE_TILE, count,
                            sums + (i * PELAGE_HIDDEN + h) * PELAGE_LANES, PELAGE_HIDDEN);
        pelage_add_products(acts + h * PELAGE_TILE, PELAGE_TILE, after + i * PELAGE_CELLS, PELAGE_CELLS, count,
                            sums + (PELAGE_SECOND + h * PELAGE_CHEMICALS + i) * PELAGE_LANES, PELAGE_CHEMICALS);
    }
    for (int h = 0; h < PELAGE_HIDDEN; ++h)
        pelage_add_biases(slopes + h * PELAGE_TILE, count, sums + (PELAGE_BIAS + h) * PELAGE_LANES);
}

// A work-item takes a run of cells of one sample. sums: [sample][run][weight][lane]; scratch: two tiles a run.
kernel void pelage_learn_reverse(global const scalar* restrict weights, global const scalar* restrict states,
                                 global const scalar* restrict after, global scalar* restrict before,
                                 global scalar* restrict scratch, global scalar* restrict sums) {
    const int run = (int)get_global_id(0);
    if (run >= PELAGE_BATCH * PELAGE_RUNS) return;
    const int sample = run / PELAGE_RUNS * PELAGE_SAMPLE;
    const int begin = run % PELAGE_RUNS * PELAGE_RUN_CELLS;
    const int end = min(begin + PELAGE_RUN_CELLS, PELAGE_CELLS);
    global scalar* acts = scratch + (long)run * (2 * PELAGE_HIDDEN * PELAGE_TILE);
    global scalar* slopes = acts + PELAGE_HIDDEN * PELAGE_TILE;
    global scalar* own = sums + (long)run * (PELAGE_WEIGHTS * PELAGE_LANES);
    for (int tile = begin; tile < end; tile += PELAGE_TILE) {
        const int count = min(PELAGE_TILE, end - tile);
        for (int place = 0; place < count; place += PELAGE_WIDTH)
            pelage_reverse_cells(weights, states + sample, after + sample, before + sample, acts, slopes, tile + place, place);
        pelage_add_tile(states + sample + tile, after + sample + tile, acts, slopes, count, own);
    }
}
