// The launches of an aggregate: see step.cl.

kernel void pelage_aggregate_gather(global const uint* restrict places, global long* restrict sums,
                                    global const uint* restrict charges, global const float* restrict sizes,
                                    global const struct pelage_front* restrict front,
                                    global const struct pelage_particle* restrict particles, const int step,
                                    global long* restrict ranges, global long* restrict parts) {
    SPACE(long, space);
    pelage_gather(places, sums, charges, sizes, front, particles[step], (int)get_group_id(0), (int)get_num_groups(0),
                  ranges, parts, space);
}

kernel void pelage_aggregate_weigh(global uint* SHARED places, global long* SHARED sums,
                                   global struct pelage_front* SHARED front,
                                   global const struct pelage_particle* restrict particles, const int step,
                                   global const long* restrict ranges, global const long* restrict parts,
                                   global ulong* restrict blocks) {
    SPACE(long, space);
    pelage_weigh(places, sums, front, particles[step], (int)get_group_id(0), (int)get_num_groups(0), ranges, parts,
                 blocks, space);
}

// One group.
kernel void pelage_aggregate_choose(global uint* restrict places, global long* restrict sums,
                                    global uint* restrict charges, global float* restrict sizes,
                                    global struct pelage_front* restrict front,
                                    global const struct pelage_particle* restrict particles, const int step,
                                    global const ulong* restrict blocks, global int* restrict left,
                                    global int* restrict sites, global uint* restrict chosen, const int columns,
                                    const int rows) {
    local ulong weights[BLOCK];
    pelage_choose(places, sums, charges, sizes, front, particles[step], blocks, left, sites, chosen + step, columns,
                  rows, weights);
}

// One group, many particles. The sums take in the last of them, too.
kernel void pelage_aggregate_together(global uint* SHARED places, global long* SHARED sums,
                                      global uint* SHARED charges, global float* SHARED sizes,
                                      global struct pelage_front* SHARED front,
                                      global const struct pelage_particle* restrict particles, const int steps,
                                      global long* SHARED ranges, global long* SHARED parts,
                                      global ulong* SHARED blocks, global int* SHARED left,
                                      global int* SHARED sites, global uint* SHARED chosen, const int columns,
                                      const int rows) {
    SPACE(long, space);
    local ulong weights[BLOCK];
    for (int step = 0; step < AT_LEAST_ONCE(steps + 1); ++step) {
        const struct pelage_particle particle = particles[min(step, steps - 1)];
        pelage_gather(places, sums, charges, sizes, front, particle, 0, 1, ranges, parts, space);
        SYNC;
        pelage_weigh(places, sums, front, particle, 0, 1, ranges, parts, blocks, space);
        SYNC;
        if (step == steps) break;
        pelage_choose(places, sums, charges, sizes, front, particle, blocks, left, sites, chosen + step, columns, rows,
                      weights);
        SYNC;
    }
}

// All sums anew.
kernel void pelage_aggregate_add_up(global const uint* restrict places, global long* restrict sums,
                                    global const uint* restrict charges, global const float* restrict sizes,
                                    const int begin, const int count, const int charged) {
    SPACE(long, space);
    const int group = (int)get_group_id(0), groups = (int)get_num_groups(0);
    const int end = begin + pelage_share(count, 1, group + 1, groups);
    for (int place = begin + pelage_share(count, 1, group, groups); place < end; ++place) {
        const uint site = places[place];
        const long sum = site == NO_SITE ? 0l : pelage_sum_at(site, charges, sizes, 0, charged, space);
        if (ITEM == 0) sums[place] = sum;
    }
}
