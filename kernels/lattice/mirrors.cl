// Neighbours in the scratch of a streamed lattice (lattice/stream.cl), beyond its edges too: there a mirrored cell must
// add up its neighbours in the order of its original, or it would not get the same bits.

#ifdef PELAGE_NO_FLUX
#define MIRRORS 1
#else
#define MIRRORS 0
#endif

// p: the value in the middle. `mirrored`: lanes beyond the left or right edge; `edge`: there are such.
static inline real pelage_beside(local const scalar* p, int side, mask mirrored, int edge) {
    if (side == 0) return LOAD(p);
    const real v = LOAD(p + side);
    return MIRRORS && edge ? SELECT(mirrored, LOAD(p - side), v) : v;
}
#define THEIRS(field) pelage_beside((field) + there, side, mirrored, edge)

// Truth where the neighbour lies inside the lattice; `column`: of the cells that stand for these.
static inline mask pelage_inside_column(uintv column, int columns, int side, int beyond_rows) {
#ifdef PELAGE_WRAP
    return ALL_TRUE;
#else
    if (beyond_rows) return ALL_FALSE;
    if (side < 0) return TO_MASK(column != (uintv)(0u));
    if (side > 0) return TO_MASK(column != (uintv)((uint)(columns - 1)));
    return ALL_TRUE;
#endif
}
