// Part of the programs that fuse iterations: looks at the neighbours of cells in scratch one by one. `row` stands for
// `at_row`, which may lie beyond the edges.
const int flipped = MIRRORS ? row != at_row : 0;
for (int k = 0; k < 3; ++k) {
    const int up = pelage_up(k, row, rows);
    const int beyond = row + up < 0 || row + up >= rows;
#ifdef PELAGE_NO_FLUX
    if (beyond) continue;
#endif
    // A mirrored row has its neighbours the other way round.
    const int there = (flipped ? -up : up) * PELAGE_FIELDS * SLOT;
    for (int side = -1; side <= 1; ++side) {
#ifdef PELAGE_FIVE_POINT
        if ((up == 0) == (side == 0)) continue;
#else
        if (up == 0 && side == 0) continue;
#endif
        const mask inside = pelage_inside_column(column, columns, side, beyond);
        const real dx = R((scalar)(2 * side));
        const real dy = R((scalar)(2 * up));
        const int diagonal = up != 0 && side != 0;
        const real norm = diagonal ? R(PELAGE_SQRT_8) : R(2);
        const real neighbour_share = diagonal ? DIAGONAL_SHARE : EDGE_SHARE;
        //@ visit
    }
}
