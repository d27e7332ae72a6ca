// Parts of the loss where many work-items are at hand: groups of them share what one work-item does in learn/loss.cl, to
// the same bits. Needs learn/loss.cl.

static inline bool pelage_later(scalar value, int pixel, scalar other, int other_pixel) {
    const uint key = pelage_key(value), other_key = pelage_key(other);
    return key > other_key || (key == other_key && pixel > other_pixel);
}

// As pelage_learn_rank; a group takes a list. Ordered stretches become twice as long by comparisons that all bring the
// smaller number first, so that what would lie beyond the list's end is never missed (K. Batcher, "Sorting networks and
// their applications", 1968).
// Lanes exchange `order` and `sorted` between barriers, so neither is `restrict`.
kernel void pelage_learn_rank_together(global const scalar* restrict seen, global int* order, global scalar* sorted) {
    const int n = (int)get_group_id(0), me = (int)get_local_id(0), all = (int)get_local_size(0);
    const int begin = pelage_begin_of(n), count = PELAGE_LEVEL_CELLS(pelage_level_of(n));
    global int* pixels = order + begin;
    global scalar* values = sorted + begin;
    for (int at = me; at < count; at += all) {
        pixels[at] = at;
        values[at] = seen[begin + at];
    }
    barrier(CLK_GLOBAL_MEM_FENCE);
    for (int stretch = 1; stretch < count; stretch *= 2) {
        const int pairs = (count + 2 * stretch - 1) / (2 * stretch) * stretch;
        for (int far = stretch; far > 0; far /= 2) {
            for (int pair = me; pair < pairs; pair += all) {
                const int low = pair / far * (2 * far) + pair % far;
                const int high = far == stretch ? pair / far * (2 * far) + 2 * far - 1 - pair % far : low + far;
                if (high >= count) continue;
                const scalar one = values[low], other = values[high];
                const int pixel = pixels[low], other_pixel = pixels[high];
                if (!pelage_later(one, pixel, other, other_pixel)) continue;
                values[low] = other;
                values[high] = one;
                pixels[low] = other_pixel;
                pixels[high] = pixel;
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
    }
}

// As pelage_learn_apart; a group of PELAGE_LANES takes a list and a rotation.
kernel void pelage_learn_apart_together(global const scalar* restrict sorted, global const scalar* restrict ranked,
                                        const int set, global scalar* restrict apart) {
    local scalar lanes[PELAGE_LANES];
    const int lane = (int)get_local_id(0);
    const int n = (int)get_group_id(0) / PELAGE_ROTATIONS, rotation = (int)get_group_id(0) % PELAGE_ROTATIONS;
    global const scalar* own = sorted + pelage_begin_of(n);
    global const scalar* target = ranked + pelage_ranked_of(n, set, rotation);
    scalar sum = 0;
    for (int rank = lane; rank < PELAGE_LEVEL_CELLS(pelage_level_of(n)); rank += PELAGE_LANES) {
        const scalar far = own[rank] - target[rank];
        sum = fma(far, far, sum);
    }
    lanes[lane] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane == 0) apart[get_group_id(0)] = pelage_folded_shared(lanes);
}

// As pelage_learn_excess; a group of PELAGE_LANES takes a run of cells.
kernel void pelage_learn_excess_together(global const scalar* restrict states, global scalar* restrict excess) {
    local scalar lanes[PELAGE_LANES];
    const int lane = (int)get_local_id(0), n = (int)get_group_id(0);
    const int begin = n % PELAGE_RUNS * PELAGE_RUN_CELLS;
    const int end = min(begin + PELAGE_RUN_CELLS, PELAGE_CELLS);
    global const scalar* own = states + n / PELAGE_RUNS * PELAGE_SAMPLE;
    scalar sum = 0;
    for (int i = 0; i < PELAGE_CHEMICALS; ++i) {
        for (int cell = begin + lane; cell < end; cell += PELAGE_LANES) {
            const scalar over = fabs(own[i * PELAGE_CELLS + cell]) - (scalar)1;
            sum = sum + (over > (scalar)0 ? over : (scalar)0);
        }
    }
    lanes[lane] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (lane == 0) excess[n] = pelage_folded_shared(lanes);
}

// As pelage_learn_nearest; a group takes a sample, and its work-items the rotations by turns.
kernel void pelage_learn_nearest_together(global const scalar* restrict apart, global const scalar* restrict excess,
                                          global const scalar* restrict shares, global scalar* restrict losses,
                                          global int* restrict nearest) {
    local scalar values[PELAGE_ROTATIONS];
    const int sample = (int)get_group_id(0), me = (int)get_local_id(0), all = (int)get_local_size(0);
    for (int rotation = me; rotation < PELAGE_ROTATIONS; rotation += all)
        values[rotation] = pelage_far(apart, shares, sample, rotation);
    barrier(CLK_LOCAL_MEM_FENCE);
    if (me != 0) return;
    int found = 0;
    for (int rotation = 1; rotation < PELAGE_ROTATIONS; ++rotation) {
        if (values[rotation] < values[found]) found = rotation;
    }
    losses[sample] = fma(shares[PELAGE_LEVELS], pelage_over_all(excess, sample), values[found]);
    nearest[sample] = found;
}
