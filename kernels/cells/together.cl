// Many iterations of a small tissue in one launch of one work-group, whose work-items take cells in turn. Lists are
// mended around cells that strayed or were born. It ends early, after a whole iteration, where all lists must be found
// anew and where children find no room.

#define PELAGE_MOST_STRAYS 64   // in one iteration
#define PELAGE_MOST_MENDED 128  // in all: to find all lists anew then costs less
#define PELAGE_MOST_CHUNKS 64
#define PELAGE_NOWHERE ((scalar)1e15f)  // its square is still finite

// Cells that are not where their lists were built.
struct pelage_strays {
    int count;
    int place[PELAGE_MOST_STRAYS];
    scalar was_x[PELAGE_MOST_STRAYS], was_y[PELAGE_MOST_STRAYS];  // when their lists were built
    scalar x[PELAGE_MOST_STRAYS], y[PELAGE_MOST_STRAYS];
};

// Those of first .. first + PELAGE_WIDTH - 1 that strayed; what finds no room is counted only.
static inline void pelage_strays_add(__local struct pelage_strays* strays, __local int* count, int first,
                                     mask strayed) {
    int lanes[PELAGE_WIDTH];
    STORE(COUNT(strayed), lanes);
    for (int lane = 0; lane < PELAGE_WIDTH; ++lane) {
        if (!lanes[lane]) continue;
        const int i = atomic_inc(count);
        if (i < PELAGE_MOST_STRAYS) strays->place[i] = first + lane;
    }
}

// All points within the square's root of point `self`, as pelage_neighbours_lists finds them.
static inline int pelage_list_anew(__global int* list, int capacity, int self, int n, __global const scalar* x,
                                   __global const scalar* y, scalar square, __global const int* ids) {
    const scalar centre_x = x[self];
    const scalar centre_y = y[self];
    int length = 0;
    for (int first = 0; first < n; first += PELAGE_WIDTH) {
        const real dx = LOAD(x + first) - R(centre_x);
        const real dy = LOAD(y + first) - R(centre_y);
        const mask near = dx * dx + dy * dy < R(square);
        if (!ANY(near)) continue;
        int lanes[PELAGE_WIDTH];
        STORE(COUNT(near), lanes);
        for (int lane = 0; lane < PELAGE_WIDTH && first + lane < n; ++lane) {
            if (lanes[lane] && first + lane != self) length = pelage_list_append(list, length, capacity, first + lane);
        }
    }
    pelage_list_sort(list, min(length, capacity), ids);
    return length;
}

// Takes the strays (marked) out of a list and puts those in, of the `count` that are named, that are near now.
static inline int pelage_list_mend(__global int* list, int length, int capacity, scalar x, scalar y, scalar square,
                                   const __local struct pelage_strays* strays, const int* named, int count,
                                   __global const int* marks, __global const int* ids) {
    int kept = 0;
    for (int k = 0; k < length; ++k) {
        const int place = list[k * PELAGE_BLOCK];
        if (marks[place]) continue;
        list[kept * PELAGE_BLOCK] = place;
        ++kept;
    }
    for (int i = 0; i < count; ++i) {
        const scalar dx = strays->x[named[i]] - x;
        const scalar dy = strays->y[named[i]] - y;
        if (!(dx * dx + dy * dy < square)) continue;
        const int place = strays->place[named[i]];
        if (kept < capacity) {
            const int id = ids[place];
            int k = kept;
            for (; k > 0 && ids[list[(k - 1) * PELAGE_BLOCK]] > id; --k) {
                list[k * PELAGE_BLOCK] = list[(k - 1) * PELAGE_BLOCK];
            }
            list[k * PELAGE_BLOCK] = place;
        }
        ++kept;
    }
    return kept;
}

// The lists of cells first .. first + PELAGE_WIDTH - 1, after some have strayed.
static inline void pelage_lists_mend(int first, int n, int pitch, __global const scalar* built, scalar square,
                                     const __local struct pelage_strays* strays, __global const int* marks,
                                     __global const int* ids, __global int* lengths, __global int* lists, int capacity,
                                     __global int* longest) {
    const real x = LOAD(built + first);
    const real y = LOAD(built + pitch + first);
    mask touched = ALL_FALSE;
    int named[PELAGE_MOST_STRAYS];  // those that are or were near one of these cells
    int count = 0;
    for (int i = 0; i < strays->count; ++i) {
        const real was_dx = R(strays->was_x[i]) - x;
        const real was_dy = R(strays->was_y[i]) - y;
        const real dx = R(strays->x[i]) - x;
        const real dy = R(strays->y[i]) - y;
        const mask meets = (was_dx * was_dx + was_dy * was_dy < R(square)) | (dx * dx + dy * dy < R(square));
        if (!ANY(meets)) continue;
        named[count++] = i;
        touched = touched | meets;
    }
    if (count == 0) return;  // a stray is near itself
    int lanes[PELAGE_WIDTH];
    STORE(COUNT(touched), lanes);
    for (int lane = 0; lane < PELAGE_WIDTH && first + lane < n; ++lane) {
        if (!lanes[lane]) continue;
        const int self = first + lane;
        __global int* list = lists + pelage_list_begin(self, capacity);
        const int length = marks[self] ? pelage_list_anew(list, capacity, self, n, built, built + pitch, square, ids)
                                       : pelage_list_mend(list, lengths[self], capacity, built[self],
                                                          built[pitch + self], square, strays, named, count, marks, ids);
        lengths[self] = length;
        if (length > capacity) atomic_max(longest, length);
    }
}

// Work-items note where the strays were and are; the newborn, which lie behind all others, were nowhere.
static inline void pelage_strays_note(int item, int items, int strayed, int newborn, int n, int pitch,
                                      __global const scalar* position, __global scalar* built, __global int* marks,
                                      __global int* lengths, __local struct pelage_strays* strays) {
    for (int i = item; i < strayed + newborn; i += items) {
        const int born = i >= strayed;
        const int place = born ? n - newborn + i - strayed : strays->place[i];
        strays->place[i] = place;
        strays->was_x[i] = born ? PELAGE_NOWHERE : built[place];
        strays->was_y[i] = born ? PELAGE_NOWHERE : built[pitch + place];
        strays->x[i] = built[place] = position[place];
        strays->y[i] = built[pitch + place] = position[pitch + place];
        marks[place] = 1;
    }
    if (item != 0) return;
    strays->count = strayed + newborn;
    for (int place = n - newborn; place < n || place % PELAGE_BLOCK != 0; ++place) lengths[place] = 0;
}

#define PELAGE_SET(of, array) (of ? array##_b : array##_a)
#define PELAGE_ALL_OF(of)                                                                               \
    PELAGE_SET(of, position), PELAGE_SET(of, conc), PELAGE_SET(of, rate), PELAGE_SET(of, polarity),     \
        PELAGE_SET(of, mapping), PELAGE_SET(of, neighbours), PELAGE_SET(of, id), PELAGE_SET(of, birth), \
        PELAGE_SET(of, fixed)
#define PELAGE_MEET barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE)

// The state is in set a before the first iteration; iterations go to and fro between the sets. An array that no
// iteration writes is the same one in both. `room`: most cells. `area` of a cell in a packed domain, else 0.
// report: iterations done, cells, children without room, whether all lists must be found anew.
__kernel void pelage_cells_together(int n, int pitch, int room, PELAGE_CELL_ARRAYS(, _a, ),
                                    PELAGE_CELL_ARRAYS(, _b, ), __global scalar* built, __global int* lengths,
                                    __global int* lists, int capacity, __global int* longest, scalar half_width,
                                    scalar half_height, scalar area, __global uint* divides, __global scalar* degrees,
                                    __global int* place_of, scalar longest_way, __global const scalar* parameters,
                                    scalar square, int chemicals,
                                    int mappings, __global const int2* pairs, __global const int* rounds,
                                    int round_count, __global int* marks, __global int* sums, __global int* report,
                                    int iterations, uint iteration) {
    if (get_group_id(0) != 0) return;
    const int item = (int)get_local_id(0);
    const int items = (int)get_local_size(0);
    // Counted in one iteration, read in the next and cleared in the one after that.
    __local int stray_counts[3], child_counts[3];
    __local struct pelage_strays strays;
    for (int i = 0; item == 0 && i < 3; ++i) stray_counts[i] = child_counts[i] = 0;
    PELAGE_MEET;
    int now = 0;  // the set that holds the state
    int done = 0;
    int children = 0;
    int mended = 0;
    int stale = longest[0] > capacity;
    while (done < iterations && !stale && children == 0) {
        const int turn = done % 3;
        const int next = !now;
        if (area > 0) half_width = half_height = (sqrt((scalar)n * area) - 2) / 2;
        for (int first = item * PELAGE_WIDTH; first < n; first += items * PELAGE_WIDTH) {
            mask strayed;
            const int asked = pelage_cells_advance(first, n, pitch, PELAGE_ALL_OF(now), PELAGE_ALL_OF(next), built,
                                                   lengths, lists, capacity, half_width, half_height, divides, degrees,
                                                   longest_way, parameters, iteration + (uint)done, &strayed);
            if (ANY(strayed)) pelage_strays_add(&strays, stray_counts + turn, first, strayed);
            if (asked > 0) atomic_add(child_counts + turn, asked);
        }
        if (item == 0) stray_counts[(turn + 1) % 3] = child_counts[(turn + 1) % 3] = 0;
        PELAGE_MEET;
        ++done;
        now = next;
#ifdef PELAGE_MIRRORS
        for (int round = 0; round < round_count; ++round) {
            for (int i = rounds[round] + item; i < rounds[round + 1]; i += items) {
                pelage_cells_even(place_of[pairs[i].x], place_of[pairs[i].y], pitch, chemicals, PELAGE_SET(now, conc),
                                  PELAGE_SET(now, rate));
            }
            PELAGE_MEET;
        }
#endif
        const int strayed = stray_counts[turn];
        int newborn = 0;
#ifdef PELAGE_DIVIDES
        newborn = child_counts[turn];
        if (n + newborn > room) {
            children = newborn;
            continue;
        }
        if (newborn > 0) {
            const int chunks = min(items, PELAGE_MOST_CHUNKS);
            const int begin = pelage_chunk_begin(n, min(item, chunks), chunks);
            const int end = pelage_chunk_begin(n, min(item + 1, chunks), chunks);
            int sum = 0;
            for (int id = begin; id < end; ++id) sum += (int)popcount(divides[id]);
            if (item < chunks) sums[item] = sum;
            PELAGE_MEET;
            pelage_cells_bear(begin, end, n + pelage_sum_before(sums, min(item, chunks)), divides, degrees, pitch,
                              chemicals, mappings, (int)(iteration + (uint)done), place_of, PELAGE_ALL_OF(!now),
                              PELAGE_ALL_OF(now));
            n += newborn;
            PELAGE_MEET;
        }
#endif
        if (strayed + newborn == 0) continue;
        mended += strayed + newborn;
        stale = strayed + newborn > PELAGE_MOST_STRAYS || mended > PELAGE_MOST_MENDED;
        if (stale) continue;
        pelage_strays_note(item, items, strayed, newborn, n, pitch, PELAGE_SET(now, position), built, marks, lengths,
                           &strays);
        PELAGE_MEET;
        for (int first = item * PELAGE_WIDTH; first < n; first += items * PELAGE_WIDTH) {
            pelage_lists_mend(first, n, pitch, built, square, &strays, marks, PELAGE_SET(now, id), lengths, lists,
                              capacity, longest);
        }
        PELAGE_MEET;
        for (int i = item; i < strayed + newborn; i += items) marks[strays.place[i]] = 0;
        stale = longest[0] > capacity;
        PELAGE_MEET;
    }
    if (item == 0) {
        report[0] = done;
        report[1] = n;
        report[2] = children;
        report[3] = stale;
    }
}
