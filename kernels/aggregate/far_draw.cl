// The draws of a choice, and where they fall.

struct pelage_far_particle {  // struct DeviceFarParticle of opencl/aggregate/far_layout.hpp
    float eta;
    float size;
    uint iteration;
    uint rule;
    uint key_low, key_high;
};

#define AGGREGATION 8u

// The draw `number` of a particle, in parts of 2^64.
static inline ulong pelage_further_draw(const struct pelage_far_particle particle, int number) {
    const struct pelage_words words = DRAW((uint)number, particle.iteration, particle.rule, AGGREGATION,
                                           particle.key_low, particle.key_high);
    return (ulong)words.y << 32 | words.x;
}

// The leaf on which a draw falls, and what is left of the draw in it: in each block row by row of the four within.
static inline int pelage_descend(const struct pelage_far far, ulong* drawn) {
    int x = 0, y = 0, found = 0;
    for (int number = far.level_count - 1; number >= 0; --number) {
        const struct pelage_level level = far.levels[number];
        const int4 part = pelage_part_of(level, 2 * x, 2 * y, 2 * x + 1, 2 * y + 1);
        const int width = part.z - part.x + 1, parts = width * (part.w - part.y + 1);
        int i = 0;
        for (; i < parts; ++i) {
            found = pelage_block(level, part.x + i % width, part.y + i / width);
            if (*drawn < far.totals[found]) break;
            *drawn -= far.totals[found];
        }
        x = part.x + i % width;
        y = part.y + i / width;
    }
    return found;
}

// The lowest and the highest of all sums.
static inline long2 pelage_range_of_all(const struct pelage_far far, local long* space) {
    float values[COEFFICIENTS];
    long lowest = LONG_MAX, highest = NOTHING;
    for (int number = 0; number < far.levels[0].columns * far.levels[0].rows; ++number) {
        const struct pelage_leaf leaf = far.leaves[number];
        if (leaf.candidates == 0) continue;
        pelage_at_nodes(far, number, values);
        for (int i = ITEM; i < leaf.candidates; i += PELAGE_ITEMS) {
            const int slot = pelage_slot(far, leaf, i);
            const long sum = far.near[slot] + pelage_far_sum(far, values, far.sites[slot]);
            lowest = min(lowest, sum);
            highest = max(highest, sum);
        }
    }
    lowest = pelage_least(lowest, space);
    return (long2)(lowest, pelage_most(highest, space));
}

static inline ulong pelage_weight_in(const struct pelage_far far, const struct pelage_scale scale,
                                     const float* values, int slot) {
    return pelage_weight_of(scale, -far.near[slot] - pelage_far_sum(far, values, far.sites[slot]));
}

static inline ulong pelage_weights_of_leaf(const struct pelage_far far, const struct pelage_scale scale, int number,
                                           local long* space) {
    const struct pelage_leaf leaf = far.leaves[number];
    float values[COEFFICIENTS];
    if (leaf.candidates > 0) pelage_at_nodes(far, number, values);
    long sum = 0l;
    for (int i = ITEM; i < leaf.candidates; i += PELAGE_ITEMS)
        sum += (long)pelage_weight_in(far, scale, values, pelage_slot(far, leaf, i));
    return (ulong)pelage_sum_of(sum, space);
}

// Where draws have been rejected too often: of all candidates, leaf by leaf, as pelage_choose() does it.
static inline uint pelage_choose_of_all(const struct pelage_far far, float eta, ulong draw, local long* space) {
    const long2 range = pelage_range_of_all(far, space);
    const struct pelage_scale scale = pelage_scale_of(-range.y, -range.x, eta);
    ulong total = 0ul, passed = 0ul;
    const int leaves = far.levels[0].columns * far.levels[0].rows;
    for (int i = 0; i < leaves; ++i) total += pelage_weights_of_leaf(far, scale, i, space);
    const ulong drawn = mul_hi(draw, total);
    int number = 0;
    for (ulong own = pelage_weights_of_leaf(far, scale, 0, space); passed + own <= drawn;
         own = pelage_weights_of_leaf(far, scale, number, space)) {
        passed += own;
        ++number;
    }
    const struct pelage_leaf leaf = far.leaves[number];
    float values[COEFFICIENTS];
    pelage_at_nodes(far, number, values);
    int index = 0;
    while (index < leaf.candidates - 1 &&
           (passed += pelage_weight_in(far, scale, values, pelage_slot(far, leaf, index))) <= drawn)
        ++index;
    return far.sites[pelage_slot(far, leaf, index)];
}

struct pelage_target {
    struct pelage_bounds bounds;
    struct pelage_scale scale;  // of the weights themselves
    ulong total;
    int attempts;
};

// The draws one after another; NO_SITE where all are rejected.
static inline uint pelage_draw_sites(const struct pelage_far far, const struct pelage_far_particle particle,
                                     const struct pelage_target target) {
    float values[COEFFICIENTS];
    for (int attempt = 0; attempt < target.attempts; ++attempt) {
        ulong drawn = mul_hi(pelage_further_draw(particle, attempt), target.total);
        const int number = pelage_descend(far, &drawn);
        const struct pelage_leaf leaf = far.leaves[number];
        const ulong each = pelage_bound(target.bounds, leaf.lowest);
        const int slot = pelage_slot(far, leaf, (int)(drawn / each));
        const ulong rest = drawn % each;
        // What is known bounds a sum, too: mostly that is enough to reject it.
        const long known = max(pelage_surely(far.known[slot]), target.bounds.lower);
        const ulong most = pelage_weight_of(target.scale, -known);
        if (rest >= most + (most >> 11) + 1ul) continue;
        pelage_at_nodes(far, number, values);
        const long sum = far.near[slot] + pelage_far_sum(far, values, far.sites[slot]);
        if (rest < pelage_weight_of(target.scale, -max(sum, target.bounds.lower))) return far.sites[slot];
    }
    return NO_SITE;
}

static inline uint pelage_far_choose(const struct pelage_far far, const struct pelage_far_particle particle,
                                     local long* space) {
    const int candidates = far.front->candidates;
    const long highest = pelage_highest(far, space);
    const float eta = floor(particle.eta * 16.0f) * 0.0625f;
    struct pelage_target target;
    pelage_bounds_of(far.front, highest, eta, &target.bounds);
    pelage_make_totals(far, target.bounds, eta);
    target.scale = pelage_scale_of(-target.bounds.upper, -target.bounds.lower, particle.eta);
    target.scale.lowest = -highest;
    target.total = pelage_total_within(far, far.levels[far.level_count - 1], 0, 0);
    target.attempts = candidates / 4 + 16;
    const uint site = pelage_draw_sites(far, particle, target);
    if (site != NO_SITE) return site;
    return pelage_choose_of_all(far, particle.eta, pelage_further_draw(particle, target.attempts), space);
}
