// A particle of an aggregate: sums and their range, weights, the choice. Either each is a launch of its own, and groups
// share the places among them in whole blocks, or one group carries out many particles in one launch.
//   PELAGE_SIZES   1: charges are of different sizes, and `sizes` holds one for each

#define BLOCK 256
#define MOST_NEW 8

struct pelage_front {  // struct DeviceFront of opencl/aggregate/device.cpp
    int places;
    int left;     // places without a candidate
    int charges;
    uint last;    // the charge that sums do not hold yet; NO_SITE: none
    int added;    // candidates without a sum
    float last_size;
    long lowest;  // of all candidates' values
    long highest;
    int place[MOST_NEW];  // of those
    uint site[MOST_NEW];
};

// The first of a group's share of `count`, in units; the share ends where the next group's begins.
static inline int pelage_share(int count, int unit, int group, int groups) {
    const int units = (count + unit - 1) / unit;
    const int each = (units + groups - 1) / groups;
    return (int)min((long)count, (long)group * each * unit);
}

// A block of 256 is dealt out to the items of a group, and an item goes through its part in several plain loops, each
// over numbers of one width: so a processor's compiler makes vectors of them. `each` counts what it has of `count`.
#define PART (BLOCK / PELAGE_ITEMS)
#define OF(first, n) ((first) + ITEM + (n) * PELAGE_ITEMS)

static inline int pelage_each(int count) { return (count - ITEM + PELAGE_ITEMS - 1) / PELAGE_ITEMS; }

// The sum at a site over some charges.
static inline long pelage_sum_at(uint site, global const uint* charges, global const float* sizes,
                                 int begin, int end, local long* space) {
    TERM inverses[PART];
    long sum = 0l;
    for (int first = begin; first < end; first += BLOCK) {
        const int each = pelage_each(min(BLOCK, end - first));
        for (int n = 0; n < each; ++n)
            inverses[n] = pelage_term(site, charges[OF(first, n)], sizes[OF(first, n)]);
        for (int n = 0; n < each; ++n) sum += (long)inverses[n];
    }
    return pelage_sum_of(sum, space);
}

struct pelage_range {
    long lowest, highest;
};

// The places of a block take in the last charge.
static inline struct pelage_range pelage_gather_block(global const uint* places, global long* sums,
                                                      int first, int each, uint last, float size,
                                                      const struct pelage_particle particle) {
    TERM inverses[PART];
    struct pelage_range range = {LONG_MAX, LONG_MIN};
    for (int n = 0; n < each; ++n) inverses[n] = pelage_term(places[OF(first, n)], last, size);
    if (last != NO_SITE) {
        for (int n = 0; n < each; ++n) sums[OF(first, n)] += (long)inverses[n];
    }
    for (int n = 0; n < each; ++n) {
        const uint site = places[OF(first, n)];
        const long value = pelage_value(particle, site, sums[OF(first, n)]);
        const long low = (site & NEW_SITE) != 0u ? LONG_MAX : value;
        const long high = (site & NEW_SITE) != 0u ? LONG_MIN : value;
        range.lowest = low < range.lowest ? low : range.lowest;
        range.highest = high > range.highest ? high : range.highest;
    }
    return range;
}

// The weights of the places of a block; a place without a candidate has none.
static inline void pelage_weigh_block(const struct pelage_scale scale, const struct pelage_particle particle,
                                      global const uint* places, global const long* sums, int first,
                                      int each, ulong* weights) {
    int above[PART];
    uint bits[PART];
    for (int n = 0; n < each; ++n)
        above[n] = pelage_above(scale, pelage_value(particle, places[OF(first, n)], sums[OF(first, n)]));
    for (int n = 0; n < each; ++n) bits[n] = pelage_weight_bits(scale, above[n]);
    for (int n = 0; n < each; ++n) {
        const ulong weight = scale.flat ? FULL_WEIGHT : pelage_weight(bits[n]);
        weights[n] = places[OF(first, n)] == NO_SITE ? 0ul : weight;
    }
}

// Sums take in the last charge. For each group: the range of its candidates' values, and what its share of the older
// charges adds to each new candidate.
static inline void pelage_gather(global const uint* places, global long* sums,
                                 global const uint* charges, global const float* sizes,
                                 global const struct pelage_front* front,
                                 const struct pelage_particle particle, int group, int groups,
                                 global long* ranges, global long* parts, local long* space) {
    const uint last = front->last;
    const float size = front->last_size;
    const int begin = pelage_share(front->places, BLOCK, group, groups);
    const int end = pelage_share(front->places, BLOCK, group + 1, groups);
    long lowest = LONG_MAX, highest = LONG_MIN;
    for (int first = begin; first < end; first += BLOCK) {
        const int each = pelage_each(min(BLOCK, end - first));
        const struct pelage_range range = pelage_gather_block(places, sums, first, each, last, size, particle);
        lowest = min(lowest, range.lowest);
        highest = max(highest, range.highest);
    }
    lowest = pelage_least(lowest, space);
    highest = pelage_most(highest, space);
    const int older = front->charges - 1;
    const int from = pelage_share(older, 1, group, groups), until = pelage_share(older, 1, group + 1, groups);
    const int added = front->added;
    for (int n = 0; n < AT_LEAST_ONCE(added); ++n) {
        const long sum = pelage_sum_at(front->site[n], charges, sizes, from, n < added ? until : from, space);
        if (ITEM == 0) parts[group * MOST_NEW + n] = sum;
    }
    if (ITEM == 0) {
        ranges[2 * group] = lowest;
        ranges[2 * group + 1] = highest;
    }
}

// The new candidates get their sums, then each candidate its weight, and each block the sum of its weights.
static inline void pelage_weigh(global uint* places, global long* sums,
                                global struct pelage_front* front, const struct pelage_particle particle,
                                int group, int groups, global const long* ranges,
                                global const long* parts, global ulong* blocks, local long* space) {
    const int begin = pelage_share(front->places, BLOCK, group, groups);
    const int end = pelage_share(front->places, BLOCK, group + 1, groups);
    long lowest = LONG_MAX, highest = LONG_MIN;
    for (int g = 0; g < groups; ++g) {
        lowest = min(lowest, ranges[2 * g]);
        highest = max(highest, ranges[2 * g + 1]);
    }
    for (int n = 0; n < front->added; ++n) {
        const int place = front->place[n];
        const uint site = front->site[n];
        long sum = (long)pelage_term(site, front->last, front->last_size);
        for (int g = 0; g < groups; ++g) sum += parts[g * MOST_NEW + n];
        const long value = pelage_value(particle, site, sum);
        lowest = min(lowest, value);
        highest = max(highest, value);
        if (ITEM == 0 && place >= begin && place < end) {
            sums[place] = sum;
            places[place] = site;
        }
    }
    SYNC;
    const struct pelage_scale scale = pelage_scale_of(lowest, highest, particle.eta);
    ulong weights[PART];
    for (int nth = 0; nth < AT_LEAST_ONCE((end - begin + BLOCK - 1) / BLOCK); ++nth) {
        const int first = begin + nth * BLOCK;
        const int each = pelage_each(clamp(end - first, 0, BLOCK));
        pelage_weigh_block(scale, particle, places, sums, first, each, weights);
        long sum = 0l;
        for (int n = 0; n < each; ++n) sum += (long)weights[n];
        sum = pelage_sum_of(sum, space);
        if (ITEM == 0 && first < end) blocks[first / BLOCK] = (ulong)sum;
    }
    if (ITEM == 0 && group == 0) {
        front->lowest = lowest;
        front->highest = highest;
    }
}

// A free site becomes a candidate: in the place that was left last, or else in a new one.
static inline void pelage_add(int x, int y, int columns, global uint* places, global long* sums,
                              global const int* left, global int* sites, global struct pelage_front* front) {
    const long at = (long)y * columns + x;
    if (sites[at] != -1) return;
    const int place = front->left > 0 ? left[--front->left] : front->places++;
    sites[at] = place;
    places[place] = SITE(x, y) | NEW_SITE;
    sums[place] = 0l;
    front->place[front->added] = place;
    front->site[front->added++] = SITE(x, y);
}

// The candidate in a place becomes a charge.
static inline void pelage_take(int place, float size, int columns, int rows, global uint* places, global long* sums,
                               global uint* charges, global float* sizes, global int* left, global int* sites,
                               global struct pelage_front* front) {
    const uint site = places[place];
    const int x = SITE_X(site), y = SITE_Y(site);
    places[place] = NO_SITE;
    left[front->left++] = place;
    sites[(long)y * columns + x] = -2;
#if PELAGE_SIZES
    sizes[front->charges] = size;
#endif
    charges[front->charges++] = site;
    front->last = site;
    front->last_size = size;
    for (int i = max(x - 1, 0); i <= min(x + 1, columns - 1); ++i) {
        for (int j = max(y - 1, 0); j <= min(y + 1, rows - 1); ++j)
            pelage_add(i, j, columns, places, sums, left, sites, front);
    }
}

// The place on which the draw falls. `weights` has room for those of a block.
static inline int pelage_chosen(const struct pelage_particle particle, global const uint* places,
                                global const long* sums, global const struct pelage_front* front,
                                global const ulong* blocks, local ulong* weights) {
    const int count = front->places, used = (count + BLOCK - 1) / BLOCK;
    ulong total = 0ul;
    for (int block = 0; block < used; ++block) total += blocks[block];
    const ulong drawn = mul_hi(particle.draw, total);
    ulong passed = 0ul;
    int block = 0;
    while (block < used - 1 && passed + blocks[block] <= drawn) passed += blocks[block++];
    const int first = block * BLOCK, most = min(BLOCK, count - first);
    const struct pelage_scale scale = pelage_scale_of(front->lowest, front->highest, particle.eta);
    ulong own[PART];
    const int each = pelage_each(most);
    pelage_weigh_block(scale, particle, places, sums, first, each, own);
    for (int n = 0; n < each; ++n) weights[OF(0, n)] = own[n];
    SYNC;
    int place = 0;
    while (place < most - 1 && (passed += weights[place]) <= drawn) ++place;
    return first + place;
}

// A candidate becomes a charge, where there is one.
static inline void pelage_choose(global uint* places, global long* sums, global uint* charges, global float* sizes,
                                 global struct pelage_front* front, const struct pelage_particle particle,
                                 global const ulong* blocks, global int* left, global int* sites, global uint* chosen,
                                 int columns, int rows, local ulong* weights) {
    const int none = front->left == front->places;
    const int place = pelage_chosen(particle, places, sums, front, blocks, weights);
    SYNC;  // all have read what one changes
    if (ITEM != 0) return;
    *chosen = none ? NO_SITE : places[place];
    front->last = NO_SITE;
    front->added = 0;
    if (none) return;
    pelage_take(place, particle.size, columns, rows, places, sums, charges, sizes, left, sites, front);
}
