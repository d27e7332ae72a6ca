// A site becomes a charge: all sums take it in, near ones at once, far ones by way of blocks.

// The candidates of a chunk take in a charge. x: the lowest of what is known, y: the highest of what the charge adds.
static inline long2 pelage_pull_chunk(global const uint* sites, global long* near, global long* known, int count,
                                      uint site, float size, long2 found) {
    long lowest = found.x, highest = found.y;
    for (int i = ITEM; i < count; i += PELAGE_ITEMS) {
        const long term = (long)pelage_term(sites[i], site, size);
        near[i] += term;
        const long sum = known[i] + term;
        known[i] = sum;
        lowest = sum < lowest ? sum : lowest;
        highest = term > highest ? term : highest;
    }
    return (long2)(lowest, highest);
}

static inline void pelage_pull_leaf(const struct pelage_far far, int number, uint site, float size,
                                    local long* space) {
    long2 found = (long2)(LONG_MAX, 0l);
    const int candidates = far.leaves[number].candidates;
    int chunk = far.leaves[number].chunk, count = pelage_in_first(candidates);
    for (int left = candidates; left > 0; left -= count, count = CHUNK) {
        if (left < candidates) chunk = far.next[chunk];
        const int first = chunk * CHUNK;
        found = pelage_pull_chunk(far.sites + first, far.near + first, far.known + first, count, site, size, found);
    }
    const long lowest = pelage_least(found.x, space), highest = pelage_most(found.y, space);
    if (ITEM != 0) return;
    far.leaves[number].lowest = lowest;
    far.best[number] = candidates == 0 ? NOTHING : far.best[number] + highest;
}

// What the charges of a leaf add at a site.
static inline long pelage_sum_of_leaf(const struct pelage_far far, int number, uint site) {
    const struct pelage_leaf leaf = far.leaves[number];
    long sum = 0l;
    int chunk = leaf.charge_chunk, count = pelage_in_first(leaf.charges);
    for (int left = leaf.charges; left > 0; left -= count, count = CHUNK) {
        if (left < leaf.charges) chunk = far.charge_next[chunk];
        global const uint* const charges = far.charges + chunk * CHUNK;
        global const float* const sizes = far.sizes + chunk * CHUNK;
        for (int i = ITEM; i < count; i += PELAGE_ITEMS) sum += (long)pelage_term(site, charges[i], sizes[i]);
    }
    return sum;
}

static inline long pelage_near_sum(const struct pelage_far far, uint site, local long* space) {
    const struct pelage_level level = far.levels[0];
    const int4 part = pelage_beside(level, SITE_X(site) / PELAGE_LEAF, SITE_Y(site) / PELAGE_LEAF);
    long sum = 0l;
    for (int y = part.y; y <= part.w; ++y) {
        for (int x = part.x; x <= part.z; ++x) sum += pelage_sum_of_leaf(far, pelage_block(level, x, y), site);
    }
    return pelage_sum_of(sum, space);
}

// The best of a block, from those of the blocks within.
static inline void pelage_lift(const struct pelage_far far, int number, int x, int y) {
    const struct pelage_level within = far.levels[number - 1];
    const int4 part = pelage_part_of(within, 2 * x, 2 * y, 2 * x + 1, 2 * y + 1);
    long best = NOTHING;
    for (int row = part.y; row <= part.w; ++row) {
        for (int column = part.x; column <= part.z; ++column)
            best = max(best, far.best[pelage_block(within, column, row)]);
    }
    const int block = pelage_block(far.levels[number], x, y);
    far.best[block] = best + far.added[block];
}

// No sum in a leaf is above this one.
static inline void pelage_set_best(const struct pelage_far far, int leaf, long best) {
    const int x = leaf % far.levels[0].columns, y = leaf / far.levels[0].columns;
    for (int number = 1; number < far.level_count; ++number)
        best -= far.added[pelage_block(far.levels[number], x >> number, y >> number)];
    far.best[leaf] = best;
    for (int number = 1; number < far.level_count; ++number) pelage_lift(far, number, x >> number, y >> number);
}

static inline long pelage_best_of(const struct pelage_far far, int leaf) {
    const int x = leaf % far.levels[0].columns, y = leaf / far.levels[0].columns;
    long best = far.best[leaf];
    for (int number = 1; number < far.level_count; ++number)
        best += far.added[pelage_block(far.levels[number], x >> number, y >> number)];
    return best;
}

// What floats may have rounded a sum up or down by is less than this.
static inline long pelage_doubt(long sum) { return (sum >> 16) + 1l; }
static inline long pelage_surely(long sum) { return sum - (sum >> 16); }

static inline void pelage_lift_beside(const struct pelage_far far, uint site) {
    for (int number = 1; number < far.level_count; ++number) {
        const struct pelage_level level = far.levels[number];
        const int4 part =
            pelage_beside(level, SITE_X(site) >> level.shift, SITE_Y(site) >> level.shift);
        for (int y = part.y; y <= part.w; ++y) {
            for (int x = part.x; x <= part.z; ++x) pelage_lift(far, number, x, y);
        }
    }
}

// A free site becomes a candidate. `values` are those of the leaf `known`, if it has them already.
static inline int pelage_offer(const struct pelage_far far, uint site, float* values, int known, local long* space) {
    const int leaf = pelage_leaf_of(far, site);
    if (leaf != known) pelage_at_nodes(far, leaf, values);
    const long near = pelage_near_sum(far, site, space);
    SYNC;
    if (ITEM == 0) {
        const long sum = near + pelage_far_sum(far, values, site);
        const int first = far.leaves[leaf].candidates == 0;
        pelage_set_state(far, SITE_X(site), SITE_Y(site), CANDIDATE);
        pelage_push(far, leaf, site, near, sum);
        far.front->lowest = min(far.front->lowest, sum);
        const long best = sum + pelage_doubt(sum);
        if (first || best > pelage_best_of(far, leaf)) pelage_set_best(far, leaf, best);
    }
    SYNC;
    return leaf;
}

// The free sites beside a charge, column by column.
static inline int pelage_free_beside(const struct pelage_far far, int x, int y, uint* found) {
    int count = 0;
    for (int i = max(x - 1, 0); i <= min(x + 1, far.columns - 1); ++i) {
        for (int j = max(y - 1, 0); j <= min(y + 1, far.rows - 1); ++j) {
            if (pelage_state(far, i, j) == FREE) found[count++] = SITE(i, j);
        }
    }
    return count;
}

// The site leaves the candidates and joins the charges.
static inline void pelage_move(const struct pelage_far far, uint site, float size) {
    const int leaf = pelage_leaf_of(far, site);
    if (pelage_state(far, SITE_X(site), SITE_Y(site)) == CANDIDATE) pelage_remove(far, leaf, site);
    pelage_set_state(far, SITE_X(site), SITE_Y(site), TAKEN);
    pelage_push_charge(far, leaf, site, size);
    if (far.front->last != NO_SITE) far.front->whole = 0;  // two charges since the totals were made
    far.front->last = site;
}

static inline void pelage_far_take(const struct pelage_far far, uint site, float size, local long* space) {
    const int x = SITE_X(site), y = SITE_Y(site);
    if (ITEM == 0) pelage_move(far, site, size);
    SYNC;
    const int4 part = pelage_beside(far.levels[0], x / PELAGE_LEAF, y / PELAGE_LEAF);
    for (int row = part.y; row <= part.w; ++row) {
        for (int column = part.x; column <= part.z; ++column)
            pelage_pull_leaf(far, pelage_block(far.levels[0], column, row), site, size, space);
    }
    for (int number = 0; number < far.level_count; ++number) pelage_spread(far, number, site, size);
    if (ITEM == 0) pelage_lift_beside(far, site);
    SYNC;
    float values[COEFFICIENTS];
    uint offered[8];
    const int count = pelage_free_beside(far, x, y, offered);
    SYNC;
    int known = -1;
    for (int n = 0; n < count; ++n) known = pelage_offer(far, offered[n], values, known, space);
}
