// One iteration of the system that learns, and the way back through it; see reference/learn/iteration.hpp. Needs
// learn/sums.cl and functions/quick_sigmoid.cl.
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
#pragma unroll 4
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* w = weights + i * PELAGE_HIDDEN + h;
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) z[k] = fma(x[i], R(w[k]), z[k]);
    }
}

// sums[i] += z[k] w[...] over a block of hidden values, whose weights lie `apart` and those of chemicals `onward`.
PELAGE_LEARN void pelage_add_block(const real* z, global const scalar* restrict w, int apart, int onward, real* sums) {
#pragma unroll 4
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        real sum = sums[i];
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) sum = fma(z[k], R(w[k * apart + i * onward]), sum);
        sums[i] = sum;
    }
}

PELAGE_LEARN void pelage_iterate_cells(global const scalar* restrict weights, global const scalar* restrict from,
                                       global scalar* restrict to, int cell) {
    real x[PELAGE_CHEMICALS], y[PELAGE_CHEMICALS];
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* plane = from + i * PELAGE_CELLS;
        x[i] = LOAD(plane + cell);
        y[i] = pelage_diffused(plane, cell / PELAGE_SIDE, cell % PELAGE_SIDE, pelage_share(i));
    }
    for (int h = 0; h < PELAGE_HIDDEN; h += PELAGE_HIDDEN_BLOCK) {
        real z[PELAGE_HIDDEN_BLOCK];
        pelage_ask(weights, x, h, z);
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) z[k] = z[k] * pelage_quick_sigmoid(R(5) * z[k]);
        pelage_add_block(z, weights + PELAGE_SECOND + h * PELAGE_CHEMICALS, PELAGE_CHEMICALS, 1, y);
    }
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) STORE(y[i], to + i * PELAGE_CELLS + cell);
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
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        global const scalar* plane = after + i * PELAGE_CELLS;
        x[i] = LOAD(state + i * PELAGE_CELLS + cell);
        dy[i] = LOAD(plane + cell);
        dx[i] = pelage_diffused(plane, cell / PELAGE_SIDE, cell % PELAGE_SIDE, pelage_share(i));
    }
    for (int h = 0; h < PELAGE_HIDDEN; h += PELAGE_HIDDEN_BLOCK) {
        real z[PELAGE_HIDDEN_BLOCK], dz[PELAGE_HIDDEN_BLOCK];
        pelage_ask(weights, x, h, z);
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) dz[k] = R(0);
        global const scalar* second = weights + PELAGE_SECOND + h * PELAGE_CHEMICALS;
#pragma unroll 4
        for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
#pragma unroll
            for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) dz[k] = fma(dy[i], R(second[k * PELAGE_CHEMICALS + i]), dz[k]);
        }
#pragma unroll
        for (int k = 0; k < PELAGE_HIDDEN_BLOCK; ++k) {
            const real s = pelage_quick_sigmoid(R(5) * z[k]);
            const real act = z[k] * s;
            dz[k] = dz[k] * fma(R(5) * act, R(1) - s, s);
            STORE(act, acts + (h + k) * PELAGE_TILE + place);
            STORE(dz[k], slopes + (h + k) * PELAGE_TILE + place);
        }
        pelage_add_block(dz, weights + h, 1, PELAGE_HIDDEN, dx);
    }
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) STORE(dx[i], before + i * PELAGE_CELLS + cell);
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

// All weights' products of one tile; the work-items of a group take turns.
PELAGE_LEARN void pelage_add_tile(global const scalar* restrict state, global const scalar* restrict after,
                                  global const scalar* restrict acts, global const scalar* restrict slopes, int count,
                                  global scalar* restrict sums, int me, int all) {
    const int across = PELAGE_HIDDEN / PELAGE_BLOCK;
    for (int block = me; block < PELAGE_CHEMICALS / PELAGE_BLOCK * across; block += all) {
        const int i = block / across * PELAGE_BLOCK;
        const int h = block % across * PELAGE_BLOCK;
        pelage_add_products(state + i * PELAGE_CELLS, PELAGE_CELLS, slopes + h * PELAGE_TILE, PELAGE_TILE, count,
                            sums + (i * PELAGE_HIDDEN + h) * PELAGE_LANES, PELAGE_HIDDEN);
        pelage_add_products(acts + h * PELAGE_TILE, PELAGE_TILE, after + i * PELAGE_CELLS, PELAGE_CELLS, count,
                            sums + (PELAGE_SECOND + h * PELAGE_CHEMICALS + i) * PELAGE_LANES, PELAGE_CHEMICALS);
    }
    for (int h = me; h < PELAGE_HIDDEN; h += all)
        pelage_add_biases(slopes + h * PELAGE_TILE, count, sums + (PELAGE_BIAS + h) * PELAGE_LANES);
}

// A group takes a run of cells of one sample. sums: [sample][run][weight][lane]; scratch: two tiles a run.
kernel void pelage_learn_reverse(global const scalar* restrict weights, global const scalar* restrict states,
                                 global const scalar* restrict after, global scalar* restrict before,
                                 global scalar* restrict scratch, global scalar* restrict sums) {
    const int me = (int)get_local_id(0);
    const int all = (int)get_local_size(0);
    for (int run = (int)get_group_id(0); run < PELAGE_BATCH * PELAGE_RUNS; run += (int)get_num_groups(0)) {
        const int sample = run / PELAGE_RUNS * PELAGE_SAMPLE;
        const int begin = run % PELAGE_RUNS * PELAGE_RUN_CELLS;
        const int end = min(begin + PELAGE_RUN_CELLS, PELAGE_CELLS);
        global scalar* acts = scratch + (long)run * (2 * PELAGE_HIDDEN * PELAGE_TILE);
        global scalar* slopes = acts + PELAGE_HIDDEN * PELAGE_TILE;
        global scalar* own = sums + (long)run * (PELAGE_WEIGHTS * PELAGE_LANES);
        for (int tile = begin; tile < end; tile += PELAGE_TILE) {
            const int count = min(PELAGE_TILE, end - tile);
            for (int place = me * PELAGE_WIDTH; place < count; place += all * PELAGE_WIDTH)
                pelage_reverse_cells(weights, states + sample, after + sample, before + sample, acts, slopes, tile + place,
                                     place);
            PELAGE_MEET;
            pelage_add_tile(states + sample + tile, after + sample + tile, acts, slopes, count, own, me, all);
            PELAGE_MEET;
        }
    }
}
