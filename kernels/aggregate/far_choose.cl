// A candidate is chosen, each by its weight: a leaf by a bound of the weights in it, a candidate in it by chance, which
// is taken with the probability weight / bound; else there is another draw.

// The highest of the sums in a leaf.
static inline long pelage_highest_in(const struct pelage_far far, int number, local long* space) {
    float values[COEFFICIENTS], columns[PELAGE_LEAF * NODES];
    pelage_at_nodes(far, number, values);
    pelage_at_columns(far, values, columns);
    const int candidates = far.leaves[number].candidates;
    int chunk = far.leaves[number].chunk, count = pelage_in_first(candidates);
    long highest = NOTHING;
    for (int left = candidates; left > 0; left -= count, count = CHUNK) {
        if (left < candidates) chunk = far.next[chunk];
        for (int i = chunk * CHUNK + ITEM; i < chunk * CHUNK + count; i += PELAGE_ITEMS)
            highest = max(highest, far.near[i] + pelage_far_sum_in(far, columns, far.sites[i]));
    }
    return pelage_most(highest, space);
}

// The leaf in which the highest sum is looked for next, and the bound of its sums.
static inline int pelage_best_leaf(const struct pelage_far far, long* bound) {
    int x = 0, y = 0, found = 0;
    *bound = 0l;
    for (int number = far.level_count - 1; number >= 0; --number) {
        const struct pelage_level level = far.levels[number];
        const int4 part = pelage_part_of(level, 2 * x, 2 * y, 2 * x + 1, 2 * y + 1);
        long best = LONG_MIN;
        for (int row = part.y; row <= part.w; ++row) {
            for (int column = part.x; column <= part.z; ++column) {
                const int block = pelage_block(level, column, row);
                if (far.best[block] <= best) continue;
                best = far.best[block];
                found = block;
                x = column;
                y = row;
            }
        }
        *bound += number == 0 ? best : far.added[found];
    }
    return found;
}

// The highest of all sums. A leaf is looked into only while its bound is above what was found.
static inline long pelage_highest(const struct pelage_far far, local long* space) {
    long found = NOTHING / 2, bound;
    int looked = 0;
    for (int leaf = pelage_best_leaf(far, &bound); bound > found; leaf = pelage_best_leaf(far, &bound)) {
        const long highest = pelage_highest_in(far, leaf, space);
        found = max(found, highest);
        SYNC;
        if (ITEM == 0) {
            far.leaves[leaf].highest = highest;
            far.looked_at[looked] = leaf;
            pelage_set_best(far, leaf, NOTHING);
        }
        ++looked;
        SYNC;
    }
    SYNC;  // all have seen that the search is over
    for (int i = 0; i < (ITEM == 0 ? looked : 0); ++i) {
        const int leaf = far.looked_at[i];
        const long highest = far.leaves[leaf].highest;
        pelage_set_best(far, leaf, highest + pelage_doubt(highest));
    }
    SYNC;
    return found;
}

struct pelage_bounds {  // of sums; and the scale of weights between them
    long lower, upper;
    struct pelage_scale scale;
};

static inline void pelage_bounds_of(global const struct pelage_far_front* front, long highest, float eta,
                                    struct pelage_bounds* bounds) {
    const int grain = front->grain;
    bounds->upper = ((highest >> grain) + 1l) << grain;
    bounds->lower = (pelage_surely(front->lowest) >> grain) << grain;
    bounds->scale = pelage_scale_of(-bounds->upper, -bounds->lower, eta);
}

static inline ulong pelage_weight_of(const struct pelage_scale scale, long value) {
    return scale.flat ? FULL_WEIGHT : pelage_weight(pelage_weight_bits(scale, pelage_above(scale, value)));
}

// No weight of a candidate in a leaf is above it.
static inline ulong pelage_bound(const struct pelage_bounds bounds, long lowest) {
    const ulong weight = pelage_weight_of(bounds.scale, -clamp(pelage_surely(lowest), bounds.lower, bounds.upper));
    return weight + (weight >> 11) + 1ul;
}

static inline ulong pelage_total_of(const struct pelage_far far, const struct pelage_bounds bounds, int number) {
    const struct pelage_leaf leaf = far.leaves[number];
    return leaf.candidates == 0 ? 0ul : (ulong)leaf.candidates * pelage_bound(bounds, leaf.lowest);
}

static inline ulong pelage_total_within(const struct pelage_far far, const struct pelage_level within, int x, int y) {
    const int4 part = pelage_part_of(within, 2 * x, 2 * y, 2 * x + 1, 2 * y + 1);
    ulong total = 0ul;
    for (int row = part.y; row <= part.w; ++row) {
        for (int column = part.x; column <= part.z; ++column)
            total += far.totals[pelage_block(within, column, row)];
    }
    return total;
}

static inline void pelage_all_totals(const struct pelage_far far, const struct pelage_bounds bounds) {
    const int leaves = far.levels[0].columns * far.levels[0].rows;
    for (int i = ITEM; i < leaves; i += PELAGE_ITEMS) far.totals[i] = pelage_total_of(far, bounds, i);
    SYNC;
    for (int number = 1; number < far.level_count; ++number) {
        const struct pelage_level level = far.levels[number];
        for (int i = ITEM; i < level.columns * level.rows; i += PELAGE_ITEMS)
            far.totals[level.first + i] =
                pelage_total_within(far, far.levels[number - 1], i % level.columns, i / level.columns);
        SYNC;
    }
}

// Those of the leaves near the last charge, and of the blocks that they lie in.
static inline void pelage_totals_beside(const struct pelage_far far, const struct pelage_bounds bounds, uint site) {
    const struct pelage_level leaves = far.levels[0];
    const int4 part = pelage_beside(leaves, SITE_X(site) / PELAGE_LEAF, SITE_Y(site) / PELAGE_LEAF);
    for (int y = part.y; y <= part.w; ++y) {
        for (int x = part.x; x <= part.z; ++x) {
            const int leaf = pelage_block(leaves, x, y);
            const ulong total = pelage_total_of(far, bounds, leaf);
            const ulong more = total - far.totals[leaf];
            for (int number = 0; number < far.level_count; ++number)
                far.totals[pelage_block(far.levels[number], x >> number, y >> number)] += more;
        }
    }
}

static inline void pelage_make_totals(const struct pelage_far far, const struct pelage_bounds bounds, float eta) {
    global struct pelage_far_front* const front = far.front;
    const int kept = front->whole && front->lower == bounds.lower && front->upper == bounds.upper && front->eta == eta;
    const uint last = front->last;
    SYNC;
    if (!kept) pelage_all_totals(far, bounds);
    if (ITEM == 0) {
        if (kept && last != NO_SITE) pelage_totals_beside(far, bounds, last);
        front->lower = bounds.lower;
        front->upper = bounds.upper;
        front->eta = eta;
        front->whole = 1;
        front->last = NO_SITE;
    }
    SYNC;
}
