// Moves all cells into the order that a sort has found, and remembers where each was when the lists were built.

#define PELAGE_GATHER(array, planes)                                                              \
    for (int plane = 0; plane < (planes); ++plane) {                                              \
        const long base = (long)plane * pitch;                                                    \
        for (int i = begin; i < end; ++i) array##_new[base + i] = array##_old[base + order[i]];   \
    }

// One work-item a chunk of cells.
__kernel void pelage_cells_gather(int n, int pitch, int chunks, int chemicals, int mappings,
                                  __global const int* restrict order, PELAGE_CELLS(const, _old), PELAGE_CELLS(, _new),
                                  __global scalar* restrict built, __global int* restrict place_of) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    const int begin = pelage_chunk_begin(n, chunk, chunks);
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    PELAGE_GATHER(position, 2)
    PELAGE_GATHER(conc, chemicals)
    PELAGE_GATHER(rate, chemicals)
    PELAGE_GATHER(polarity, 2)
    PELAGE_GATHER(mapping, mappings)
    PELAGE_GATHER(neighbours, 1)
    PELAGE_GATHER(id, 1)
    PELAGE_GATHER(birth, 1)
    PELAGE_GATHER(fixed, 1)
    for (int i = begin; i < end; ++i) {
        built[i] = position_new[i];
        built[pitch + i] = position_new[pitch + i];
        place_of[id_new[i]] = i;
    }
}
