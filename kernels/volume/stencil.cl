// The Laplacian in a volume of a chemical with one rate for all cells. Layers lie one after another, each as
// lattice/rows.cl says: row `row` of layer `layer` is row layer * rows + row of the plane.
//   PELAGE_SEVEN_POINT or PELAGE_TWENTY_SEVEN_POINT

#define WHOLE_LAYERS ((uint)layers)

// Elements from the plane's row 0 to the row that stands for one beside this; beyond an absorbing face zeros.
static inline long pelage_line(int row, int layer, int rows, int layers, int pitch) {
    const int there = pelage_row_beyond(row, rows);
    const int deep = pelage_row_beyond(layer, layers);
    return there < 0 || deep < 0 ? -(long)pitch : ((long)deep * rows + there) * pitch;
}

// Of the rows around this one, declared as `lines` by the step.
#define LINE(up, deep) lines[3 * (deep) + (up) + 4]
#define VALUE(plane, up, deep) LOAD((plane) + LINE(up, deep) + x)
#define SIDES(plane, up, deep) \
    (pelage_left((plane) + LINE(up, deep), x, columns) + pelage_right((plane) + LINE(up, deep), x, columns))

#ifdef PELAGE_SEVEN_POINT
// Where neighbours before and behind have the cell's own value this is the five-point stencil, to the bit.
#define PLANE_SUM(p, c) fma(R(-4), c, (VALUE(p, -1, 0) + VALUE(p, 1, 0)) + SIDES(p, 0, 0))
#define VOLUME_LAPLACIAN(p, c) (PLANE_SUM(p, c) + fma(R(-2), c, VALUE(p, 0, -1) + VALUE(p, 0, 1)))
#else
// 3 and 1 of a row off both middles, 14 and 3 of a row off one.
#define OUTER_ROW(p, up, deep) fma(R(3), VALUE(p, up, deep), SIDES(p, up, deep))
#define INNER_ROW(p, up, deep) fma(R(14), VALUE(p, up, deep), R(3) * SIDES(p, up, deep))
#define OUTER_LAYER(p, deep) ((OUTER_ROW(p, -1, deep) + OUTER_ROW(p, 1, deep)) + INNER_ROW(p, 0, deep))
#define MIDDLE_LAYER(p) fma(R(14), SIDES(p, 0, 0), INNER_ROW(p, -1, 0) + INNER_ROW(p, 1, 0))
#define VOLUME_LAPLACIAN(p, c) \
    fma(R(-128), c, (OUTER_LAYER(p, -1) + OUTER_LAYER(p, 1)) + MIDDLE_LAYER(p))
#endif

// As the names of lattice/stencil.cl, without sums that a next row uses again.
#define ROLL_AHEAD(i, row) const real c##i = LOAD(a##i + at);
#define ROLL_DIFFUSE(i) n##i = fma(share##i, VOLUME_LAPLACIAN(a##i, c##i), n##i);
#define ROLL_ON(i)

// See lattice/exchange.cl. `away`: along how many axes the neighbour lies off.
#define LOOK_GRADIENT(i)                                                                                 \
    if (away == 1) {                                                                                     \
        const real half_step = (THEIRS(a##i) - c##i) * R((scalar)0.5f);                                  \
        const real signed_step = side + up + deep < 0 ? -half_step : half_step;                          \
        if (side != 0) slope_x##i = SELECT(MEETS, slope_x##i + signed_step, slope_x##i);                 \
        else if (up != 0) slope_y##i = SELECT(MEETS, slope_y##i + signed_step, slope_y##i);              \
        else slope_z##i = SELECT(MEETS, slope_z##i + signed_step, slope_z##i);                           \
    }
