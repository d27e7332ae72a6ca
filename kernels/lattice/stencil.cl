// The Laplacian of a chemical with one rate for all cells, by sums of rows that the next row uses again.
//   PELAGE_NINE_POINT, PELAGE_SIMS, PELAGE_MOORE or PELAGE_FIVE_POINT; not used with PELAGE_OWN_WEIGHTS
// [1 4 1; 4 -20 4; 1 4 1] is [1 4 1] times itself, less 36 in the middle.

// ROW_SUM: of a row's own cells. OUTER: what the rows above and below take of it.
#if defined(PELAGE_NINE_POINT) || defined(PELAGE_SIMS)
#define ROW_SUM(l, c, r) fma(R(4), c, (l) + (r))
#define OUTER(sum, c) (sum)
#define LAPLACIAN(below, own, above, c) fma(R(-36), c, fma(R(4), own, (below) + (above)))
#elif defined(PELAGE_MOORE)
#define ROW_SUM(l, c, r) (((l) + (r)) + (c))
#define OUTER(sum, c) (sum)
#define LAPLACIAN(below, own, above, c) fma(R(-9), c, ((below) + (above)) + (own))
#else
#define ROW_SUM(l, c, r) ((l) + (r))
#define OUTER(sum, c) (c)
#define LAPLACIAN(below, own, above, c) fma(R(-4), c, ((below) + (above)) + (own))
#endif

static inline real pelage_row_sum(global const scalar* row, real c, int x, int columns) {
    return ROW_SUM(pelage_left(row, x, columns), c, pelage_right(row, x, columns));
}

// Chemical i, whose plane is a##i: c##i of the row to come, its sum, and what it takes of the row below.
#define ROLL_START(i, row)                                                    \
    real c##i = LOAD(a##i + ROW_AT((row) - 1) + x);                           \
    real own##i = pelage_row_sum(a##i + ROW_AT((row) - 1), c##i, x, columns); \
    real below##i = OUTER(own##i, c##i);                                      \
    c##i = LOAD(a##i + ROW_AT(row) + x);                                      \
    own##i = pelage_row_sum(a##i + ROW_AT(row), c##i, x, columns);

#define ROLL_AHEAD(i, row)                                  \
    const real up##i = LOAD(a##i + ROW_AT((row) + 1) + x);  \
    const real up_sum##i = pelage_row_sum(a##i + ROW_AT((row) + 1), up##i, x, columns);

#define ROLL_DIFFUSE(i) n##i = fma(share##i, LAPLACIAN(below##i, own##i, OUTER(up_sum##i, up##i), c##i), n##i);

#define ROLL_ON(i)                  \
    below##i = OUTER(own##i, c##i); \
    own##i = up_sum##i;             \
    c##i = up##i;
