// How far what has grown is from the target, and the slopes of that along each number; see reference/learn/loss.hpp. Needs
// learn/sums.cl and the settings of learn/iteration.cl. Pictures stand as [sample][level][colour][pixel], what is seen of
// them as [sample][level][direction][pixel].
//   PELAGE_ROTATIONS, PELAGE_SET_NUMBERS   rotations of the target; numbers of one set of ranked values
// A level's pixels begin, in units of what one pixel holds, where those of the levels before end.

#define PELAGE_LEVELS 3
#define PELAGE_COLOURS 3
#define PELAGE_PATCH 7
#define PELAGE_DIRECTIONS 32
#define PELAGE_VIEWS (PELAGE_DIRECTIONS / PELAGE_WIDTH)  // vectors that hold what one patch has along all directions
#define PELAGE_LEVEL_SIDE(level) (PELAGE_SIDE >> (level))
#define PELAGE_LEVEL_CELLS(level) (PELAGE_LEVEL_SIDE(level) * PELAGE_LEVEL_SIDE(level))
#define PELAGE_LEVEL_BEGIN(level) \
    ((level) == 0 ? 0 : (level) == 1 ? PELAGE_CELLS : PELAGE_CELLS + PELAGE_LEVEL_CELLS(1))
#define PELAGE_ALL_CELLS (PELAGE_CELLS + PELAGE_LEVEL_CELLS(1) + PELAGE_LEVEL_CELLS(2))

// A pixel of the picture, or of a level the mean of four of the level before; one work-item each.
kernel void pelage_learn_shrink(global const scalar* restrict states, global scalar* restrict pictures, const int level) {
    const int side = PELAGE_LEVEL_SIDE(level);
    const int many = PELAGE_COLOURS * side * side;
    const int n = (int)get_global_id(0);
    if (n >= PELAGE_BATCH * many) return;
    const int sample = n / many, pixel = n % many;
    global scalar* own = pictures + sample * (PELAGE_COLOURS * PELAGE_ALL_CELLS);
    global scalar* to = own + PELAGE_COLOURS * PELAGE_LEVEL_BEGIN(level) + pixel;
    if (level == 0) {
        *to = states[sample * PELAGE_SAMPLE + pixel];
        return;
    }
    const int colour = pixel / (side * side), row = pixel / side % side, column = pixel % side;
    global const scalar* four = own + PELAGE_COLOURS * PELAGE_LEVEL_BEGIN(level - 1) + colour * 4 * side * side +
                                (2 * row) * (2 * side) + 2 * column;
    *to = (scalar)0.25f * ((four[0] + four[1]) + (four[2 * side] + four[2 * side + 1]));
}

// Four patches side by side, along all directions.
PELAGE_LEARN void pelage_look(global const scalar* restrict picture, global const scalar* restrict directions, int side,
                              int row, int column, global scalar* restrict seen) {
    real sums[4][PELAGE_VIEWS];
#pragma unroll
    for (int n = 0; n < 4; ++n) {
#pragma unroll
        for (int view = 0; view < PELAGE_VIEWS; ++view) sums[n][view] = R(0);
    }
    for (int place = 0; place < PELAGE_COLOURS * PELAGE_PATCH; ++place) {
        const int colour = place / PELAGE_PATCH, low = row + place % PELAGE_PATCH;
        global const scalar* line = picture + (colour * side + (low >= side ? low - side : low)) * side;
        for (int across = 0; across < PELAGE_PATCH; ++across) {
            global const scalar* along = directions + (place * PELAGE_PATCH + across) * PELAGE_DIRECTIONS;
#pragma unroll
            for (int n = 0; n < 4; ++n) {
                const int at = column + across + n;
                const real value = R(line[at >= side ? at - side : at]);
#pragma unroll
                for (int view = 0; view < PELAGE_VIEWS; ++view)
                    sums[n][view] = fma(value, LOAD(along + view * PELAGE_WIDTH), sums[n][view]);
            }
        }
    }
    for (int n = 0; n < 4; ++n) {
        scalar lanes[PELAGE_DIRECTIONS];
        for (int view = 0; view < PELAGE_VIEWS; ++view) STORE(sums[n][view], lanes + view * PELAGE_WIDTH);
        for (int direction = 0; direction < PELAGE_DIRECTIONS; ++direction)
            seen[direction * side * side + row * side + column + n] = lanes[direction];
    }
}

// A work-item takes `many` pixels of a row, a multiple of 4, where it goes on so far.
kernel void pelage_learn_look(global const scalar* restrict pictures, global const scalar* restrict directions,
                              const int set, global scalar* restrict seen, const int level, const int many) {
    const int side = PELAGE_LEVEL_SIDE(level), pieces = (side + many - 1) / many;
    const int line = (int)get_global_id(0) / pieces, begin = (int)get_global_id(0) % pieces * many;
    const int sample = line / side, row = line % side;
    if (sample >= PELAGE_BATCH) return;
    global const scalar* picture =
        pictures + PELAGE_COLOURS * (sample * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level));
    global scalar* own = seen + PELAGE_DIRECTIONS * (sample * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level));
    global const scalar* of_level = directions + (set * PELAGE_LEVELS + level) *
                                                     (PELAGE_COLOURS * PELAGE_PATCH * PELAGE_PATCH * PELAGE_DIRECTIONS);
    for (int column = begin; column < min(begin + many, side); column += 4)
        pelage_look(picture, of_level, side, row, column, own);
}

// A work-item's numbers: those of one direction, level and sample. `n` counts these.
static inline int pelage_level_of(int n) { return n / PELAGE_DIRECTIONS % PELAGE_LEVELS; }
static inline int pelage_begin_of(int n) {
    const int level = pelage_level_of(n);
    const int sample = n / (PELAGE_DIRECTIONS * PELAGE_LEVELS);
    return PELAGE_DIRECTIONS * (sample * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level)) +
           n % PELAGE_DIRECTIONS * PELAGE_LEVEL_CELLS(level);
}
static inline long pelage_ranked_of(int n, int set, int rotation) {
    const int level = pelage_level_of(n);
    return (long)set * PELAGE_SET_NUMBERS + (long)PELAGE_DIRECTIONS * (rotation * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level)) +
           n % PELAGE_DIRECTIONS * PELAGE_LEVEL_CELLS(level);
}

// A whole number that is larger where the number is.
static inline uint pelage_key(float value) {
    const uint bits = as_uint(value);
    return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

// One pass of a stable sort by eight bits of the keys. from: null-like in the first pass, when pixels come as they are.
static inline void pelage_sort_pass(global const scalar* seen, global const int* from, global int* to, int count, int pass) {
    int places[256];
    for (int digit = 0; digit < 256; ++digit) places[digit] = 0;
    for (int n = 0; n < count; ++n) places[(pelage_key(seen[n]) >> (8 * pass)) & 255u] += 1;
    int begin = 0;
    for (int digit = 0; digit < 256; ++digit) {
        const int many = places[digit];
        places[digit] = begin;
        begin += many;
    }
    for (int n = 0; n < count; ++n) {
        const int pixel = pass == 0 ? n : from[n];
        const int place = places[(pelage_key(seen[pixel]) >> (8 * pass)) & 255u]++;
        to[place] = pixel;
    }
}

// What is seen along each direction in ascending order; of equal numbers the first pixel is first.
kernel void pelage_learn_rank(global const scalar* restrict seen, global int* restrict order, global int* restrict aside,
                              global scalar* restrict sorted) {
    const int n = (int)get_global_id(0);
    if (n >= PELAGE_BATCH * PELAGE_LEVELS * PELAGE_DIRECTIONS) return;
    const int begin = pelage_begin_of(n), count = PELAGE_LEVEL_CELLS(pelage_level_of(n));
    pelage_sort_pass(seen + begin, order + begin, aside + begin, count, 0);
    pelage_sort_pass(seen + begin, aside + begin, order + begin, count, 1);
    pelage_sort_pass(seen + begin, order + begin, aside + begin, count, 2);
    pelage_sort_pass(seen + begin, aside + begin, order + begin, count, 3);
    for (int rank = 0; rank < count; ++rank) sorted[begin + rank] = seen[begin + order[begin + rank]];
}

// Squares of the distances to each rotation of the target: [sample][level][direction][rotation].
kernel void pelage_learn_apart(global const scalar* restrict sorted, global const scalar* restrict ranked, const int set,
                               global scalar* restrict apart) {
    const int n = (int)get_global_id(0);
    if (n >= PELAGE_BATCH * PELAGE_LEVELS * PELAGE_DIRECTIONS) return;
    global const scalar* own = sorted + pelage_begin_of(n);
    const int count = PELAGE_LEVEL_CELLS(pelage_level_of(n));
    for (int rotation = 0; rotation < PELAGE_ROTATIONS; ++rotation) {
        global const scalar* target = ranked + pelage_ranked_of(n, set, rotation);
        real parts[PELAGE_PARTS];
        for (int part = 0; part < PELAGE_PARTS; ++part) parts[part] = R(0);
        for (int rank = 0; rank < count; rank += PELAGE_LANES) {
            for (int part = 0; part < PELAGE_PARTS; ++part) {
                const int at = rank + part * PELAGE_WIDTH;
                const real far = LOAD(own + at) - LOAD(target + at);
                parts[part] = fma(far, far, parts[part]);
            }
        }
        apart[n * PELAGE_ROTATIONS + rotation] = pelage_folded_parts(parts, PELAGE_PARTS);
    }
}

// What the chemicals of a run of cells have beyond -1 and 1: [sample][run].
kernel void pelage_learn_excess(global const scalar* restrict states, global scalar* restrict excess) {
    const int n = (int)get_global_id(0);
    if (n >= PELAGE_BATCH * PELAGE_RUNS) return;
    const int begin = n % PELAGE_RUNS * PELAGE_RUN_CELLS;
    const int end = min(begin + PELAGE_RUN_CELLS, PELAGE_CELLS);
    global const scalar* own = states + n / PELAGE_RUNS * PELAGE_SAMPLE;
    real parts[PELAGE_PARTS];
    for (int part = 0; part < PELAGE_PARTS; ++part) parts[part] = R(0);
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        for (int cell = begin; cell < end; cell += PELAGE_LANES) {
            for (int part = 0; part < PELAGE_PARTS; ++part) {
                const real over = fabs(LOAD(own + i * PELAGE_CELLS + cell + part * PELAGE_WIDTH)) - R(1);
                parts[part] = parts[part] + SELECT(over > R(0), over, R(0));
            }
        }
    }
    excess[n] = pelage_folded_parts(parts, PELAGE_PARTS);
}

// From a sample to one rotation of the target. shares: of each level, and of the excess.
static inline scalar pelage_far(global const scalar* apart, global const scalar* shares, int sample, int rotation) {
    scalar value = 0;
    for (int n = 0; n < PELAGE_LEVELS * PELAGE_DIRECTIONS; ++n) {
        const int place = sample * (PELAGE_LEVELS * PELAGE_DIRECTIONS) + n;
        value = fma(shares[n / PELAGE_DIRECTIONS], apart[place * PELAGE_ROTATIONS + rotation], value);
    }
    return value;
}

static inline scalar pelage_over_all(global const scalar* excess, int sample) {
    scalar over = 0;
    for (int run = 0; run < PELAGE_RUNS; ++run) over = over + excess[sample * PELAGE_RUNS + run];
    return over;
}

// A work-item takes a sample: its loss, and the rotation of the target that is nearest.
kernel void pelage_learn_nearest(global const scalar* restrict apart, global const scalar* restrict excess,
                                 global const scalar* restrict shares, global scalar* restrict losses,
                                 global int* restrict nearest) {
    const int sample = (int)get_global_id(0);
    if (sample >= PELAGE_BATCH) return;
    scalar best = pelage_far(apart, shares, sample, 0);
    int found = 0;
    for (int rotation = 1; rotation < PELAGE_ROTATIONS; ++rotation) {
        const scalar value = pelage_far(apart, shares, sample, rotation);
        if (value < best) {
            best = value;
            found = rotation;
        }
    }
    losses[sample] = fma(shares[PELAGE_LEVELS], pelage_over_all(excess, sample), best);
    nearest[sample] = found;
}

// Slopes along what is seen, with all directions of a pixel side by side: [sample][level][pixel][direction]. A work-item
// takes `many` ranks of a list, where it goes on so far; lists come in `pieces` of these.
kernel void pelage_learn_along(global const scalar* restrict sorted, global const int* restrict order,
                               global const scalar* restrict ranked, const int set, global const int* restrict nearest,
                               global const scalar* restrict factors, global scalar* restrict along, const int many,
                               const int pieces) {
    const int n = (int)get_global_id(0) / pieces, first = (int)get_global_id(0) % pieces * many;
    if (n >= PELAGE_BATCH * PELAGE_LEVELS * PELAGE_DIRECTIONS) return;
    const int sample = n / (PELAGE_LEVELS * PELAGE_DIRECTIONS), level = pelage_level_of(n), begin = pelage_begin_of(n);
    global const scalar* target = ranked + pelage_ranked_of(n, set, nearest[sample]);
    global scalar* own = along + PELAGE_DIRECTIONS * (sample * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level));
    for (int rank = first; rank < min(first + many, PELAGE_LEVEL_CELLS(level)); ++rank)
        own[order[begin + rank] * PELAGE_DIRECTIONS + n % PELAGE_DIRECTIONS] =
            factors[level] * (sorted[begin + rank] - target[rank]);
}

// Along one pixel of a level: it is a part of 49 patches.
PELAGE_LEARN void pelage_slope_at(global const scalar* restrict along, global const scalar* restrict directions, int side,
                                  int row, int column, global scalar* restrict slopes) {
    real sums[PELAGE_COLOURS][PELAGE_VIEWS];
#pragma unroll
    for (int colour = 0; colour < PELAGE_COLOURS; ++colour) {
#pragma unroll
        for (int view = 0; view < PELAGE_VIEWS; ++view) sums[colour][view] = R(0);
    }
    for (int place = 0; place < PELAGE_PATCH * PELAGE_PATCH; ++place) {
        const int low = row - place / PELAGE_PATCH, left = column - place % PELAGE_PATCH;
        const int patch = (low < 0 ? low + side : low) * side + (left < 0 ? left + side : left);
#pragma unroll
        for (int view = 0; view < PELAGE_VIEWS; ++view) {
            const real slope = LOAD(along + patch * PELAGE_DIRECTIONS + view * PELAGE_WIDTH);
#pragma unroll
            for (int colour = 0; colour < PELAGE_COLOURS; ++colour) {
                const int number = colour * PELAGE_PATCH * PELAGE_PATCH + place;
                const real one = LOAD(directions + number * PELAGE_DIRECTIONS + view * PELAGE_WIDTH);
                sums[colour][view] = fma(one, slope, sums[colour][view]);
            }
        }
    }
#pragma unroll
    for (int colour = 0; colour < PELAGE_COLOURS; ++colour)
        slopes[(colour * side + row) * side + column] = pelage_folded_parts(sums[colour], PELAGE_VIEWS);
}

// A work-item takes `many` pixels of a row, where it goes on so far. slopes stand as pictures do.
kernel void pelage_learn_slopes(global const scalar* restrict along, global const scalar* restrict directions,
                                const int set, global scalar* restrict slopes, const int level, const int many) {
    const int side = PELAGE_LEVEL_SIDE(level), pieces = (side + many - 1) / many;
    const int line = (int)get_global_id(0) / pieces, left = (int)get_global_id(0) % pieces * many;
    const int sample = line / side, row = line % side;
    if (sample >= PELAGE_BATCH) return;
    const int begin = sample * PELAGE_ALL_CELLS + PELAGE_LEVEL_BEGIN(level);
    global const scalar* of_level = directions + (set * PELAGE_LEVELS + level) *
                                                     (PELAGE_COLOURS * PELAGE_PATCH * PELAGE_PATCH * PELAGE_DIRECTIONS);
    for (int column = left; column < min(left + many, side); ++column)
        pelage_slope_at(along + PELAGE_DIRECTIONS * begin, of_level, side, row, column, slopes + PELAGE_COLOURS * begin);
}

// Slopes along every number of the states; one work-item each. push: of the excess.
kernel void pelage_learn_begin(global const scalar* restrict states, global const scalar* restrict slopes,
                               const scalar push, global scalar* restrict after) {
    const int n = (int)get_global_id(0);
    if (n >= PELAGE_BATCH * PELAGE_SAMPLE) return;
    const int sample = n / PELAGE_SAMPLE, place = n % PELAGE_SAMPLE;
    scalar slope = states[n] > (scalar)1 ? push : states[n] < (scalar)-1 ? -push : (scalar)0;
    if (place < PELAGE_COLOURS * PELAGE_CELLS) {
        global const scalar* own = slopes + sample * (PELAGE_COLOURS * PELAGE_ALL_CELLS);
        // Rows count on through the colours.
        const int row = place / PELAGE_SIDE, column = place % PELAGE_SIDE;
        const scalar smallest = own[PELAGE_COLOURS * PELAGE_LEVEL_BEGIN(2) + row / 4 * PELAGE_LEVEL_SIDE(2) + column / 4];
        const scalar smaller = own[PELAGE_COLOURS * PELAGE_LEVEL_BEGIN(1) + row / 2 * PELAGE_LEVEL_SIDE(1) + column / 2];
        slope = fma((scalar)0.25f, fma((scalar)0.25f, smallest, smaller), own[place]) + slope;
    }
    after[n] = slope;
}
