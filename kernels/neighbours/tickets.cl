// Sorting points into bins on devices with thousands of small processors, one work-item a point: each takes a ticket
// of its bin, in whatever order they come. The few points of a bin are put in order afterwards, so that the result is
// the one of common/sort.cl, which does the sorting where a bin is crowded.
//   PELAGE_TEAM           work-items of a group, a power of two
//   PELAGE_RUN            bins that a work-item counts
//   PELAGE_MOST_OF_A_BIN  points that one work-item may put in order

// What the work-items before this one hold together, of what each says to be its `own`.
static inline int pelage_team_before(local int* sums, int lane, int own) {
    sums[lane] = own;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int reach = 1; reach < PELAGE_TEAM; reach *= 2) {
        const int more = lane >= reach ? sums[lane - reach] : 0;
        barrier(CLK_LOCAL_MEM_FENCE);
        sums[lane] += more;
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    return sums[lane] - own;
}

// The box around the points of each group: left, right, bottom, top, as in pelage_bins_box.
kernel __attribute__((reqd_work_group_size(PELAGE_TEAM, 1, 1))) void pelage_tickets_box(
    global const scalar* restrict positions, int pitch, int n, global scalar* restrict boxes) {
    local scalar sides[4][PELAGE_TEAM];
    const int lane = (int)get_local_id(0);
    scalar left = INFINITY, right = -INFINITY, bottom = INFINITY, top = -INFINITY;
    for (int i = (int)get_global_id(0); i < n; i += (int)get_global_size(0)) {
        const scalar x = positions[i];
        const scalar y = positions[pitch + i];
        left = x < left ? x : left;
        right = x > right ? x : right;
        bottom = y < bottom ? y : bottom;
        top = y > top ? y : top;
    }
    sides[0][lane] = left;
    sides[1][lane] = right;
    sides[2][lane] = bottom;
    sides[3][lane] = top;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (int half_of = PELAGE_TEAM / 2; half_of > 0; half_of /= 2) {
        if (lane < half_of) {
            sides[0][lane] = fmin(sides[0][lane], sides[0][lane + half_of]);
            sides[1][lane] = fmax(sides[1][lane], sides[1][lane + half_of]);
            sides[2][lane] = fmin(sides[2][lane], sides[2][lane + half_of]);
            sides[3][lane] = fmax(sides[3][lane], sides[3][lane + half_of]);
        }
        barrier(CLK_LOCAL_MEM_FENCE);
    }
    if (lane != 0) return;
    for (int side = 0; side < 4; ++side) boxes[4 * (int)get_group_id(0) + side] = sides[side][0];
}

// counts must be 0.
kernel void pelage_tickets_take(global const scalar* restrict positions, int pitch, int n,
                                global const struct pelage_grid* restrict grid_in, global int* restrict keys,
                                global int* restrict tickets, volatile global int* counts) {
    const int i = (int)get_global_id(0);
    if (i >= n) return;
    const struct pelage_grid grid = *grid_in;
    const int column = pelage_bin_along(positions[i], grid.x, grid.per_x, grid.columns);
    const int row = pelage_bin_along(positions[pitch + i], grid.y, grid.per_y, grid.rows);
    const int key = row * grid.columns + column;
    keys[i] = key;
    tickets[i] = atomic_inc(counts + key);
}

// How many points the bins of each group hold, and how many the fullest bin of all: fullest[0] grows to it.
kernel __attribute__((reqd_work_group_size(PELAGE_TEAM, 1, 1))) void pelage_tickets_sum(
    global const int* restrict counts, int bins, global int* restrict sums, volatile global int* fullest) {
    local int before[PELAGE_TEAM];
    const int lane = (int)get_local_id(0);
    const int begin = (int)get_global_id(0) * PELAGE_RUN;
    int own = 0, most = 0;
    for (int bin = begin; bin < min(begin + PELAGE_RUN, bins); ++bin) {
        own += counts[bin];
        most = max(most, counts[bin]);
    }
    const int all_before = pelage_team_before(before, lane, own);
    if (lane == PELAGE_TEAM - 1) sums[get_group_id(0)] = all_before + own;
    if (most > PELAGE_MOST_OF_A_BIN) atomic_max(fullest, most);
}

// One group: sums become what all groups before hold.
kernel __attribute__((reqd_work_group_size(PELAGE_TEAM, 1, 1))) void pelage_tickets_scan(global int* restrict sums,
                                                                                       int groups) {
    local int before[PELAGE_TEAM];
    const int lane = (int)get_local_id(0);
    const int begin = pelage_chunk_begin(groups, lane, PELAGE_TEAM);
    const int end = pelage_chunk_begin(groups, lane + 1, PELAGE_TEAM);
    int own = 0;
    for (int i = begin; i < end; ++i) own += sums[i];
    int place = pelage_team_before(before, lane, own);
    for (int i = begin; i < end; ++i) {
        const int found = sums[i];
        sums[i] = place;
        place += found;
    }
}

// starts[bin]: the place of its first point; starts[bins] == n.
kernel __attribute__((reqd_work_group_size(PELAGE_TEAM, 1, 1))) void pelage_tickets_starts(
    global const int* restrict counts, int bins, int n, global const int* restrict sums,
    global int* restrict starts) {
    local int before[PELAGE_TEAM];
    const int begin = (int)get_global_id(0) * PELAGE_RUN;
    const int end = min(begin + PELAGE_RUN, bins);
    int own = 0;
    for (int bin = begin; bin < end; ++bin) own += counts[bin];
    int place = sums[get_group_id(0)] + pelage_team_before(before, (int)get_local_id(0), own);
    for (int bin = begin; bin < end; ++bin) {
        starts[bin] = place;
        place += counts[bin];
    }
    if (get_global_id(0) == 0) starts[bins] = n;
}

kernel void pelage_tickets_redeem(global const int* restrict keys, global const int* restrict tickets, int n,
                                  global const int* restrict starts, global int* restrict order) {
    const int i = (int)get_global_id(0);
    if (i < n) order[starts[keys[i]] + tickets[i]] = i;
}

// Puts the points of each bin in order, one work-item a bin.
kernel void pelage_tickets_tidy(global const int* restrict starts, global const int* restrict bins,
                                global int* restrict order) {
    const int bin = (int)get_global_id(0);
    if (bin >= bins[0]) return;
    const int begin = starts[bin];
    const int end = starts[bin + 1];
    for (int i = begin + 1; i < end; ++i) {
        const int moved = order[i];
        int place = i;
        for (; place > begin && order[place - 1] > moved; --place) order[place] = order[place - 1];
        order[place] = moved;
    }
}
