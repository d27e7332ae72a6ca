// Four numbers of a table that every work-item reads, whose address is a multiple of theirs: FETCH_FOUR(w, p) and then
// FOURTH(w, p, 0) to FOURTH(w, p, 3). A GPU takes them in one access; a processor takes each where it is needed.
#if PELAGE_WIDTH == 1
typedef PELAGE_PASTE(PELAGE_SCALAR, 4) pelage_four;
#define FETCH_FOUR(w, p) const pelage_four w = *(global const pelage_four*)(p)
#define FOURTH(w, p, n) w.s##n
#else
#define FETCH_FOUR(w, p)
#define FOURTH(w, p, n) R((p)[n])
#endif
