// How programs that fuse iterations fetch cells beyond the edges of a lattice, and put back those of their own.
//   PELAGE_DEPTH     most levels of a launch
//   PELAGE_FIELDS    values of a cell that pass through: concentrations, rates, polarity, mappings
//   PELAGE_SEEN      fields, the first ones, whose neighbouring values are looked at one by one
//   PELAGE_VISITS    there are such
// Fields lie in scratch, SLOT elements from one to the next, field `at` of a row in `above` at at * SLOT.

// The column or row that stands for `i`, which may lie beyond the edges; `beyond` where it stands for nothing.
static inline int pelage_stands_for(int i, int count, int beyond) {
#if defined(PELAGE_WRAP)
    if (i < 0) i += count;
    if (i >= count) i -= count;
#elif defined(PELAGE_NO_FLUX)
    if (i < 0) i = -1 - i;
    if (i >= count) i = 2 * count - 1 - i;
#else
    if (i < 0 || i >= count) return beyond;
#endif
    return clamp(i, 0, count - 1);
}

// Elements of a row at x .. x + PELAGE_WIDTH - 1, by what stands for them. Past a row's cells lies a 0.
static inline real pelage_gather(global const scalar* row, int x, int columns) {
    scalar lanes[PELAGE_WIDTH];
    PELAGE_ROLLED
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = row[pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, columns)];
    }
    return LOAD(lanes);
}

static inline real pelage_fetch(global const scalar* row, int x, int columns) {
    return x >= 0 && x + PELAGE_WIDTH <= columns ? LOAD(row + x) : pelage_gather(row, x, columns);
}

static inline intv pelage_fetch_whole(global const int* row, int x, int columns) {
    int lanes[PELAGE_WIDTH];
    PELAGE_ROLLED
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = row[pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, columns)];
    }
    return LOAD(lanes);
}

static inline uintv pelage_columns(int x, int columns) {
    uint lanes[PELAGE_WIDTH];
    PELAGE_ROLLED
    for (int k = 0; k < PELAGE_WIDTH; ++k) {
        lanes[k] = (uint)pelage_stands_for(min(x + k, columns + PELAGE_DEPTH - 1), columns, 0);
    }
    return LOAD(lanes);
}

// Cells of v at x .. that belong to [from, to) go to the row.
static inline void pelage_put(real v, global scalar* row, int x, int from, int to) {
    if (x >= from && x + PELAGE_WIDTH <= to) {
        STORE(v, row + x);
        return;
    }
#if PELAGE_WIDTH > 1
    scalar lanes[PELAGE_WIDTH];
    STORE(v, lanes);
    PELAGE_ROLLED
    for (int k = max(from - x, 0); k < min(to - x, PELAGE_WIDTH); ++k) row[x + k] = lanes[k];
#endif
}

#define WHOLE_NEIGHBOURS TO_UINT(pelage_fetch_whole(neighbours + (long)row * pitch, x, columns))
#define WHOLE_BIRTH TO_UINT(pelage_fetch_whole(birth + (long)row * pitch, x, columns))
#define WHOLE_AGE ((uintv)(iteration)-WHOLE_BIRTH)
#define WHOLE_ROW ((uint)row)
#define WHOLE_COLUMN column
#define GET_X place_x
#define GET_Y R(places[pitch + row])

// Chemical i lies in field `at` of the scratch; `above` is the row over the cell's.
#define TAKE(i, at) const real up##i = LOAD(above + (at) * SLOT);
#define TAKE_SUM(i, at) \
    const real up_sum##i = ROW_SUM(LOAD(above + (at) * SLOT - 1), up##i, LOAD(above + (at) * SLOT + 1));

// For lattice/neighbours.cl: `row` stands for `at_row`, which may lie beyond the edges; a mirrored row has its
// neighbours the other way round.
#define THERE(up) ((long)(MIRRORS && row != at_row ? -(up) : (up)) * PELAGE_FIELDS * SLOT)
#define INSIDE(side, beyond) pelage_inside_column(column, columns, side, beyond)
