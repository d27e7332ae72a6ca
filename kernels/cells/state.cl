// The arrays of a tissue of free cells, in physical order: each a row of planes, `pitch` cells long.

#define PELAGE_CELL_ARRAYS(access, of, alone)                                     \
    __global access scalar *alone position##of,      /* x, y */                  \
        __global access scalar *alone conc##of,      /* a plane a chemical */    \
        __global access scalar *alone rate##of,      /* a plane a chemical */    \
        __global access scalar *alone polarity##of,  /* x, y */                  \
        __global access scalar *alone mapping##of,   /* a plane a mapping */     \
        __global access int *alone neighbours##of,   /* as counted last */       \
        __global access int *alone id##of, __global access int *alone birth##of, \
        __global access int *alone fixed##of
#define PELAGE_CELLS(access, of) PELAGE_CELL_ARRAYS(access, of, restrict)
#define PELAGE_THESE(of) \
    position##of, conc##of, rate##of, polarity##of, mapping##of, neighbours##of, id##of, birth##of, fixed##of

// What a step leaves for the next one, and for the host once a batch.
struct pelage_progress {
    int moved;     // some cell has moved too far since the lists were built
    int children;  // born in this step
    int skipped;   // nothing was done, for the lists could not be relied on
    int unused;
};
