// The launches of an aggregate with a far field.

#define FAR_PARAMETERS                                                                                               \
    global const struct pelage_level *levels, global const float *tables, global struct pelage_far_front *front,      \
        global struct pelage_leaf *leaves, global long *coefficients, global long *added, global long *best,          \
        global ulong *totals, global uint *states, global uint *sites, global long *near, global long *known,         \
        global int *next, global uint *charges, global float *sizes, global int *charge_next, global int *looked_at,  \
        const int level_count, const int columns, const int rows
#define FAR                                                                                                          \
    {levels, tables, front, leaves, coefficients, added, best,        totals,    states,      sites,   near,          \
     known,  next,   charges, sizes, charge_next, looked_at, level_count, columns, rows}

// One group, many particles: each draws its site.
kernel void pelage_far_grow(FAR_PARAMETERS, global const struct pelage_far_particle* restrict particles,
                            const int steps, global uint* restrict chosen) {
    SPACE(long, space);
    const struct pelage_far far = FAR;
    for (int step = 0; step < steps; ++step) {
        const struct pelage_far_particle particle = particles[step];
        const int some = far.front->candidates > 0;
        if (ITEM == 0) chosen[step] = NO_SITE;
        SYNC;
        if (some) {
            const uint site = pelage_far_choose(far, particle, space);
            SYNC;
            if (ITEM == 0) chosen[step] = site;
            pelage_far_take(far, site, particle.size, space);
        }
    }
}

// One group, charges that are known.
kernel void pelage_far_replay(FAR_PARAMETERS, global const uint* restrict arrived, global const float* restrict large,
                              const int count) {
    SPACE(long, space);
    const struct pelage_far far = FAR;
    for (int i = 0; i < count; ++i) pelage_far_take(far, arrived[i], large[i], space);
}

// All sums are looked at; groups share the leaves. In `shown` the sums are told, if it is asked for, each beside its
// site; else they become what is known.
static inline void pelage_look_at(const struct pelage_far far, int number, int show, global uint* shown_sites,
                                  global long* shown, local long* space) {
    global struct pelage_leaf* const leaf = far.leaves + number;
    const int candidates = leaf->candidates;
    float values[COEFFICIENTS], columns[PELAGE_LEAF * NODES];
    pelage_at_nodes(far, number, values);
    pelage_at_columns(far, values, columns);
    long lowest = LONG_MAX, highest = NOTHING;
    int chunk = leaf->chunk, count = pelage_in_first(candidates);
    for (int left = candidates; left > 0; left -= count, count = CHUNK) {
        if (left < candidates) chunk = far.next[chunk];
        for (int i = chunk * CHUNK + ITEM; i < chunk * CHUNK + count; i += PELAGE_ITEMS) {
            const long sum = far.near[i] + pelage_far_sum_in(far, columns, far.sites[i]);
            lowest = min(lowest, sum);
            highest = max(highest, sum);
            if (show) shown_sites[i] = far.sites[i];
            (show ? shown : far.known)[i] = sum;
        }
    }
    lowest = pelage_least(lowest, space);
    highest = pelage_most(highest, space);
    if (ITEM != 0 || show) return;
    leaf->lowest = lowest;  // no other item reads these two
    leaf->highest = highest;
}

kernel void pelage_far_look(FAR_PARAMETERS, const int show, global uint* shown_sites, global long* shown) {
    SPACE(long, space);
    const struct pelage_far far = FAR;
    const int count = far.levels[0].columns * far.levels[0].rows;
    for (int number = (int)get_group_id(0); number < count; number += (int)get_num_groups(0)) {
        if (far.leaves[number].candidates > 0) pelage_look_at(far, number, show, shown_sites, shown, space);
    }
}

// One group, after that: the bounds are made anew.
kernel void pelage_far_renew(FAR_PARAMETERS) {
    SPACE(long, space);
    const struct pelage_far far = FAR;
    long lowest = LONG_MAX, highest = NOTHING;
    for (int i = ITEM; i < far.levels[0].columns * far.levels[0].rows; i += PELAGE_ITEMS) {
        const struct pelage_leaf leaf = far.leaves[i];
        far.added[i] = 0l;
        far.best[i] = leaf.candidates == 0 ? NOTHING : leaf.highest + pelage_doubt(leaf.highest);
        if (leaf.candidates == 0) continue;
        lowest = min(lowest, leaf.lowest);
        highest = max(highest, leaf.highest);
    }
    SYNC;
    for (int number = 1; number < far.level_count; ++number) {
        const struct pelage_level level = far.levels[number];
        for (int i = ITEM; i < level.columns * level.rows; i += PELAGE_ITEMS) {
            far.added[level.first + i] = 0l;
            pelage_lift(far, number, i % level.columns, i / level.columns);
        }
        SYNC;
    }
    lowest = pelage_least(lowest, space);
    highest = pelage_most(highest, space);
    if (ITEM != 0) return;
    far.front->lowest = lowest;
    far.front->grain = far.front->candidates == 0 ? 0 : max(0, 57 - (int)clz((ulong)(highest - lowest)));
    far.front->whole = 0;
    far.front->last = NO_SITE;
}
