// Part of the programs of a lattice: looks at the neighbours of cells one by one. THERE(up) is the offset of the row above
// or below in what is looked at, INSIDE(side, beyond) the truth where that neighbour lies inside the lattice.
for (int k = 0; k < 2 * PELAGE_REACH + 1; ++k) {
    const int up = pelage_up(k, row, rows) + 1 - PELAGE_REACH;
    const int beyond = row + up < 0 || row + up >= rows;
#ifdef PELAGE_NO_FLUX
    if (beyond) continue;
#endif
    const long there = THERE(up);
#ifdef PELAGE_OWN_WEIGHTS
    const real own_shares[(2 * PELAGE_REACH + 1) * (2 * PELAGE_REACH + 1)] = OWN_SHARES;
#endif
    for (int side = -PELAGE_REACH; side <= PELAGE_REACH; ++side) {
#ifdef PELAGE_FIVE_POINT
        if ((up == 0) == (side == 0)) continue;
#else
        if (up == 0 && side == 0) continue;
#endif
        const mask inside = INSIDE(side, beyond);
        const real dx = R((scalar)(2 * side));
        const real dy = R((scalar)(2 * up));
        const int diagonal = up != 0 && side != 0;
        const real norm = diagonal ? R(PELAGE_SQRT_8) : R(2);
#ifdef PELAGE_OWN_WEIGHTS
        const real neighbour_share = own_shares[(2 * PELAGE_REACH + 1) * (PELAGE_REACH - up) + side + PELAGE_REACH];
#else
        const real neighbour_share = diagonal ? DIAGONAL_SHARE : EDGE_SHARE;
#endif
        //@ visit
    }
}
