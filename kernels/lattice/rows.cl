// How a lattice lies in memory, and the boundary.
//   PELAGE_NO_FLUX, PELAGE_WRAP or PELAGE_ABSORBING     what lies beyond the edge
//   PELAGE_REACH       how far away neighbours are: 1, or 2 with weights of one's own
//
// A plane holds one value for every cell: rows of `pitch` elements, of which the first `columns` are cells and the
// others, at least 16, are 0. Before row 0 lies a row of zeros. So what an absorbing boundary reads is in memory.
// Planes begin 16 elements into their buffer.

#ifndef PELAGE_REACH
#define PELAGE_REACH 1
#endif

#define WHOLE_ROWS ((uint)rows)
#define WHOLE_COLUMNS ((uint)columns)

#define PLANE(buffer, nth) ((buffer) + 16 + (nth) * plane + pitch)

static inline int pelage_row_beyond(int row, int rows) {
#if defined(PELAGE_WRAP)
    return row < 0 ? rows - 1 : row >= rows ? 0 : row;
#elif defined(PELAGE_NO_FLUX)
    return row < 0 ? 0 : row >= rows ? rows - 1 : row;
#else
    return row >= rows ? -1 : row;
#endif
}

// Elements from the plane's row 0 to the row that stands for `row`, which may lie one beyond the edge.
#define ROW_AT(row) ((long)pelage_row_beyond(row, rows) * pitch)

// Truth for the lane that holds that column.
#define LANE_OF(column) TO_MASK((LANES + (uintv)(x)) == (uintv)((uint)(column)))

// The cells beside those at x .. x + PELAGE_WIDTH - 1 of a row, on the left.
static inline real pelage_left(global const scalar* row, int x, int columns) {
    real v = LOAD(row + x - 1);
#ifndef PELAGE_ABSORBING
#ifdef PELAGE_WRAP
    if (x == 0) v = SELECT(LANE_OF(0), R(row[columns - 1]), v);
#else
    if (x == 0) v = SELECT(LANE_OF(0), R(row[0]), v);
#endif
#endif
    return v;
}

static inline real pelage_right(global const scalar* row, int x, int columns) {
    real v = LOAD(row + x + 1);
#ifndef PELAGE_ABSORBING
#ifdef PELAGE_WRAP
    if (x + PELAGE_WIDTH >= columns) v = SELECT(LANE_OF(columns - 1), R(row[0]), v);
#else
    if (x + PELAGE_WIDTH >= columns) v = SELECT(LANE_OF(columns - 1), R(row[columns - 1]), v);
#endif
#endif
    return v;
}

static inline real pelage_side(global const scalar* row, int x, int columns, int side) {
    return side < 0 ? pelage_left(row, x, columns) : side > 0 ? pelage_right(row, x, columns) : LOAD(row + x);
}

// The place in a line of `count` that stands for one up to 3 beyond its ends; -1 beyond an absorbing end.
static inline int pelage_place_around(int place, int count) {
#if defined(PELAGE_WRAP)
    return (place % count + count) % count;
#elif defined(PELAGE_NO_FLUX)
    return clamp(place, 0, count - 1);
#else
    return place < 0 || place >= count ? -1 : place;
#endif
}

#define ROW_AROUND(row) ((long)pelage_place_around(row, rows) * pitch)

// The cells `side` places, up to 3, beside those at x .. x + PELAGE_WIDTH - 1 of a row.
static inline real pelage_around(global const scalar* row, int x, int columns, int side) {
    real v = LOAD(row + x + side);
#ifndef PELAGE_ABSORBING
    for (int k = 0; k < 3; ++k) {
        if (k >= abs(side)) break;
        const int column = side < 0 ? k : columns - 1 - k;
        if (column < x || column >= x + PELAGE_WIDTH) continue;
        v = SELECT(LANE_OF(column), R(row[pelage_place_around(column + side, columns)]), v);
    }
#endif
    return v;
}
