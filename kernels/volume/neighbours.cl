// Part of the step of a volume: looks at the neighbours of cells one by one, from the layer before to the one behind, in
// each from the row below to the one above, in each from left to right.
for (int deep = -1; deep <= 1; ++deep) {
    for (int up = -1; up <= 1; ++up) {
        const int beyond = row + up < 0 || row + up >= rows || layer + deep < 0 || layer + deep >= layers;
#ifdef PELAGE_NO_FLUX
        if (beyond) continue;
#endif
        const long there = LINE(up, deep);
        for (int side = -1; side <= 1; ++side) {
            const int away = (side != 0) + (up != 0) + (deep != 0);
#ifdef PELAGE_SEVEN_POINT
            if (away != 1) continue;
#else
            if (away == 0) continue;
#endif
            const mask inside = pelage_inside(x, columns, side, beyond);
            const real neighbour_share = away == 1 ? FACE_SHARE : away == 2 ? EDGE_SHARE : CORNER_SHARE;
            //@ visit
        }
    }
}
