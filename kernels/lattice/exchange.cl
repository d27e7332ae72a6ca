// Diffusion neighbour by neighbour: for the published arithmetic, for rates that differ between cells, and gradients.
// The code around visits up = -1, 0, 1 in the order of the arithmetic and side = -1, 0, 1, or from -2 to 2 where
// PELAGE_REACH says so; `there` is the offset of that row in a plane. Neighbours lie 2 apart.

#ifdef PELAGE_DOUBLE
#define PELAGE_SQRT_8 0x1.6a09e667f3bcdp+1
#else
#define PELAGE_SQRT_8 0x1.6a09e6p+1f
#endif

#if PELAGE_REACH > 1
#define THEIRS(plane) pelage_around((plane) + there, x, columns, side)
#define BESIDE (abs(side) <= 1 && abs(up) <= 1)
#else
#define BESIDE 1
#endif

#ifndef THEIRS
#define THEIRS(plane) pelage_side((plane) + there, x, columns, side)
#endif

// Which rows come in which order; the published program begins at an edge with the row inside.
static inline int pelage_up(int k, int row, int rows) {
#if defined(PELAGE_PUBLISHED) && !defined(PELAGE_WRAP)
    if (row == 0) return k == 0 ? 1 : k == 1 ? 0 : -1;
    if (row + 1 == rows) return k == 0 ? 0 : k == 1 ? -1 : 1;
#endif
    return k - 1;
}

// Truth where the neighbour lies inside the lattice.
static inline mask pelage_inside(int x, int columns, int side, int beyond_rows) {
#ifdef PELAGE_WRAP
    return ALL_TRUE;
#else
    if (beyond_rows) return ALL_FALSE;
#if PELAGE_REACH > 1
    if (abs(side) == 2) return side < 0 ? !LANE_OF(0) & !LANE_OF(1) : !LANE_OF(columns - 1) & !LANE_OF(columns - 2);
#endif
    if (side < 0) return !LANE_OF(0);
    if (side > 0) return !LANE_OF(columns - 1);
    return ALL_TRUE;
#endif
}

// 1 / sqrt(8) as a sum of two numbers.
#ifdef PELAGE_DOUBLE
#define PELAGE_INVERSE_HIGH 0x1.6a09e667f3bccp-2
#define PELAGE_INVERSE_LOW 0.0
#else
#define PELAGE_INVERSE_HIGH 0x1.6a09e6p-2f
#define PELAGE_INVERSE_LOW 0x1.9fcef4p-27f
#endif

// A rate as felt along d = (dx, dy), where the cell has a polarity: rate * |d . p| / |d|. The published program takes
// product and quotient in double and rounds once to float; two floats in place of each double give the same bits.
static inline real pelage_directed(real rate, real px, real py, real dx, real dy, int diagonal) {
    const real along = fabs(dx * px + dy * py);
    real felt;
    if (diagonal) {
        const real product = rate * along;
        const real product_error = fma(rate, along, -product);
        const real quotient = product * R(PELAGE_INVERSE_HIGH);
        const real quotient_error = fma(product, R(PELAGE_INVERSE_HIGH), -quotient);
        felt = quotient + ((quotient_error + product_error * R(PELAGE_INVERSE_HIGH)) + product * R(PELAGE_INVERSE_LOW));
    } else {
        felt = rate * (along * R((scalar)0.5f));
    }
    return SELECT((px != R(0)) | (py != R(0)), felt, rate);
}

#ifdef PELAGE_ABSORBING
#define MEETS ALL_TRUE  // beyond the edge lies 0, at the cell's own rate
#define MEAN_RATE(own, theirs) SELECT(inside, pelage_shared_rate(own, theirs), own)
#else
#define MEETS inside
#define MEAN_RATE(own, theirs) pelage_shared_rate(own, theirs)
#endif

// Chemical i with plane a##i and one rate for all; or with a plane of rates d##i; or with rates that feel direction.
#define EXCHANGE_UNIFORM(i) n##i = SELECT(MEETS, FLOW(n##i, r##i, neighbour_share, THEIRS(a##i) - c##i), n##i);

#define EXCHANGE_PER_CELL(i)                                                    \
    {                                                                           \
        const real e = MEAN_RATE(r##i, THEIRS(d##i));                           \
        const real difference = THEIRS(a##i) - c##i;                            \
        n##i = SELECT(MEETS, FLOW(n##i, e, neighbour_share, difference), n##i); \
    }

#define EXCHANGE_DIRECTED(i)                                                                                            \
    {                                                                                                                   \
        const real own = pelage_directed(r##i, px, py, dx, dy, diagonal);                                               \
        const real e = MEAN_RATE(own, pelage_directed(THEIRS(d##i), THEIRS(old_px), THEIRS(old_py), dx, dy, diagonal)); \
        const real difference = THEIRS(a##i) - c##i;                                                                    \
        n##i = SELECT(MEETS, FLOW(n##i, e, neighbour_share, difference), n##i);                                         \
    }

// As the two before where the means are already there, `means##i` the first of their planes (lattice/means.cl).
static inline real pelage_mean(global const scalar* means, long plane, long at, long there, int x, int columns, int side,
                               int up) {
    if (up > 0 || (up == 0 && side > 0)) return LOAD(means + (up == 0 ? 0 : side + 2) * plane + at);
    return pelage_side(means + (up == 0 ? 0 : 2 - side) * plane + there, x, columns, side);
}

#ifdef PELAGE_ABSORBING
#define KNOWN_MEAN(mean, own) SELECT(inside, mean, own)
#else
#define KNOWN_MEAN(mean, own) (mean)
#endif

#define EXCHANGE_MEANT(i, own)                                                                         \
    {                                                                                                  \
        const real e = KNOWN_MEAN(pelage_mean(means##i, plane, at, there, x, columns, side, up), own); \
        const real difference = THEIRS(a##i) - c##i;                                                   \
        n##i = SELECT(MEETS, FLOW(n##i, e, neighbour_share, difference), n##i);                        \
    }

// What rules read of the neighbours of chemical i: the laplacian in cells, half of what lies between both sides.
#define LOOK_LAPLACIAN(i) lap##i = SELECT(MEETS, fma(neighbour_share, THEIRS(a##i) - c##i, lap##i), lap##i);

#ifndef LOOK_GRADIENT
#define LOOK_GRADIENT(i)                                                                       \
    if (BESIDE && !diagonal) {                                                                 \
        const real half_step = (THEIRS(a##i) - c##i) * R((scalar)0.5f);                        \
        const real signed_step = side + up < 0 ? -half_step : half_step;                       \
        if (up == 0) slope_x##i = SELECT(MEETS, slope_x##i + signed_step, slope_x##i);         \
        else slope_y##i = SELECT(MEETS, slope_y##i + signed_step, slope_y##i);                 \
    }
#endif

#define GRADIENT(i)                                                      \
    if (BESIDE) {                                                        \
        const real difference = THEIRS(a##i) - c##i;                     \
        gx##i = SELECT(inside, gx##i + (difference * dx) / norm, gx##i); \
        gy##i = SELECT(inside, gy##i + (difference * dy) / norm, gy##i); \
    }
