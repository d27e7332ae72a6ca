// Moves all cells into the order that a sort has found, and remembers where each was when the lists were built.

#define PELAGE_MOVE(array, planes)                                                              \
    for (int plane = 0; plane < (planes); ++plane) {                                              \
        const long base = (long)plane * pitch;                                                    \
        for (int i = begin; i < end; ++i) array##_new[base + i] = array##_old[base + order[i]];   \
    }

// One work-item a chunk of cells.
__kernel void pelage_cells_move(int n, int pitch, int chunks, int chemicals, int mappings,
                                  __global const int* restrict order, PELAGE_CELLS(const, _old), PELAGE_CELLS(, _new),
                                  __global scalar* restrict built, __global int* restrict place_of) {
    const int chunk = (int)get_global_id(0);
    if (chunk >= chunks) return;
    const int begin = pelage_chunk_begin(n, chunk, chunks);
    const int end = pelage_chunk_begin(n, chunk + 1, chunks);
    PELAGE_MOVE(position, 2)
    PELAGE_MOVE(conc, chemicals)
    PELAGE_MOVE(rate, chemicals)
    PELAGE_MOVE(polarity, 2)
    PELAGE_MOVE(mapping, mappings)
    PELAGE_MOVE(neighbours, 1)
    PELAGE_MOVE(id, 1)
    PELAGE_MOVE(birth, 1)
    PELAGE_MOVE(fixed, 1)
    for (int i = begin; i < end; ++i) {
        built[i] = position_new[i];
        built[pitch + i] = position_new[pitch + i];
        place_of[id_new[i]] = i;
    }
}
