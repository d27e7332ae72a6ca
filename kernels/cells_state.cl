// The arrays of a tissue of free cells, in physical order: each a row of planes, `pitch` cells long.

#define PELAGE_CELLS(access, of)                                                      \
    __global access scalar *restrict position##of,      /* x, y */                    \
        __global access scalar *restrict conc##of,      /* a plane a chemical */      \
        __global access scalar *restrict rate##of,      /* a plane a chemical */      \
        __global access scalar *restrict polarity##of,  /* x, y */                    \
        __global access scalar *restrict mapping##of,   /* a plane a mapping */       \
        __global access int *restrict neighbours##of,   /* as counted last */         \
        __global access int *restrict id##of, __global access int *restrict birth##of, \
        __global access int *restrict fixed##of

// What a step leaves for the next one, and for the host once a batch.
struct pelage_progress {
    int moved;     // some cell has moved too far since the lists were built
    int children;  // born in this step
    int skipped;   // nothing was done, for the lists could not be relied on
    int unused;
};
